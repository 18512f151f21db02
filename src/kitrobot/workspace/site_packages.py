"""The Python packages of a static site as one archive (tar): KitRobot with its examples, and what its server imports.

Packages without compiled parts are taken as they are installed here, with their licences; of pydantic_core the wheel
for Pyodide, whose version must be the installed one. Names, order and dates in the archive depend on the files alone.
"""

from __future__ import annotations

import io
import re
import tarfile
import zipfile
from collections.abc import Iterator
from importlib.metadata import PackageNotFoundError, distribution
from pathlib import Path
from typing import Final

from kitrobot.files import examples_folder
from kitrobot.workspace.site_sources import without_texts

USED: Final = ("fastapi", "mpremote", "python-minifier")
"""The server, and what `kitrobot.deploy` puts programs onto boards with."""
_NOT_SENT: Final = ("pyserial", "platformdirs")
"""What mpremote requires, and nothing uses there: the page has the ports (`server.in_worker`)."""
COMPILED: Final = "pydantic-core"

_ROOT = Path(__file__).resolve().parent.parent.parent
_OURS: Final = ("kitrobot", "kitrobot_onboard")
_ONBOARD: Final = "kitrobot_onboard/"
_LEFT_OUT: Final = ("kitrobot/cli/", "kitrobot/server/static/", "kitrobot/examples/", "kitrobot/workspace/site_files/")
_NOT_USED: Final = (
    *("anyio/pytest_plugin.py", "pydantic/mypy.py", "pydantic/v1/", "fastapi/cli.py", "idna/uts46data.py"),
    *("mpremote/commands.py", "mpremote/main.py", "mpremote/mip.py", "mpremote/repl.py", "mpremote/romfs.py"),
    "python_minifier/__main__.py",
)
"""Large parts that are never imported there."""
_ABOUT: Final = ("licen", "copying", "notice", "/metadata", "/entry_points.txt")
"""What is taken of what a package says of itself: licences, and what packages look one another up by."""


def archive_of_packages(wheel: Path) -> bytes:
    """The archive, with sources without texts; `wheel` is pydantic_core's."""
    files = dict(_own()) | dict(_installed()) | dict(_in_wheel(wheel))
    made = io.BytesIO()
    with tarfile.open(fileobj=made, mode="w", format=tarfile.USTAR_FORMAT) as archive:
        for name, data in sorted(files.items()):
            # What is put onto boards goes there as it is.
            if name.endswith(".py") and not name.startswith(_ONBOARD):
                data = without_texts(data)
            about = tarfile.TarInfo(name)
            about.size = len(data)
            archive.addfile(about, io.BytesIO(data))
    return made.getvalue()


def _own() -> Iterator[tuple[str, bytes]]:
    for package in _OURS:
        yield from _below(_ROOT / package, package)
    examples = examples_folder()
    if examples is not None:
        yield from _below(examples, "kitrobot/examples", left_out=())


def _below(folder: Path, name: str, left_out: tuple[str, ...] = _LEFT_OUT) -> Iterator[tuple[str, bytes]]:
    for path in folder.rglob("*"):
        inner = f"{name}/{path.relative_to(folder).as_posix()}"
        hidden = any(part.startswith(".") or part == "__pycache__" for part in path.relative_to(folder).parts)
        if path.is_file() and not hidden and not inner.startswith(left_out):
            yield inner, path.read_bytes()


def needed() -> list[str]:
    """What is imported there, and what that requires; what only other Pythons require is not here."""
    found: set[str] = set()
    waiting = [*USED]
    while waiting:
        name = waiting.pop()
        if name in found or name == COMPILED or name in _NOT_SENT:
            continue
        try:
            required = distribution(name).requires or []
        except PackageNotFoundError:
            continue
        found.add(name)
        plain = [line for line in required if "extra ==" not in line]
        waiting += [re.split(r"[^\w.-]", line, maxsplit=1)[0].lower().replace("_", "-") for line in plain]
    return sorted(found)


def _installed() -> Iterator[tuple[str, bytes]]:
    for name in needed():
        for entry in distribution(name).files or ():
            inner = entry.as_posix()
            about = ".dist-info/" in inner and any(word in inner.lower() for word in _ABOUT)
            if about or (inner.endswith(".py") and not inner.startswith(_NOT_USED)):
                yield inner, Path(str(entry.locate())).read_bytes()


def _in_wheel(wheel: Path) -> Iterator[tuple[str, bytes]]:
    with zipfile.ZipFile(wheel) as archive:
        for name in archive.namelist():
            if not name.endswith(("/", ".pyi", "/RECORD")):
                yield name, archive.read(name)
