"""The Python packages of a static site as one archive (tar): KitRobot with its examples, and what its server imports.

Packages without compiled parts are taken as they are installed here, with their licences; of pydantic_core the wheel
for Pyodide, whose version must be the installed one. Names, order and dates in the archive depend on the files alone.
"""

from __future__ import annotations

import io
import re
import tarfile
import zipfile
import zlib
from collections.abc import Iterator
from importlib.metadata import PackageNotFoundError, distribution
from pathlib import Path
from typing import Final

from kitrobot.exercise.hidden_parts import remove_hidden_parts
from kitrobot.files.examples import examples_folder
from kitrobot.files.folder import EXERCISE_ENDING
from kitrobot.packaging.site_sources import without_texts

USED: Final = ("fastapi", "mpremote", "python-minifier")
"""The server, and what `kitrobot.deploy` puts programs onto boards with."""
_NOT_SENT: Final = ("pyserial", "platformdirs", "idna")
"""What mpremote and anyio require, and nothing uses there: ports are the page's (`server.in_worker`), hosts are not."""
COMPILED: Final = "pydantic-core"

_ROOT = Path(__file__).resolve().parent.parent.parent
_OURS: Final = ("kitrobot", "kitrobot_onboard")
_ONBOARD: Final = "kitrobot_onboard/"
_LEFT_OUT: Final = (
    *("kitrobot/cli/", "kitrobot/server/static/", "kitrobot/examples/", "kitrobot/packaging/site_files/"),
    *("kitrobot/primitives/schemas/", "kitrobot/workspace/conversion.py"),
)
_NOT_USED: Final = (
    *("anyio/pytest_plugin.py", "anyio/_backends/_trio.py", "pydantic/mypy.py", "pydantic/v1/", "fastapi/cli.py"),
    *("annotated_types/test_cases.py", "starlette/testclient.py", "pydantic/experimental/pipeline.py"),
    *("mpremote/commands.py", "mpremote/main.py", "mpremote/mip.py", "mpremote/repl.py", "mpremote/romfs.py"),
    "python_minifier/__main__.py",
)
"""Large parts that are never imported there."""
_ABOUT: Final = ("licen", "copying", "notice", "/metadata", "/entry_points.txt")
"""What is taken of what a package says of itself: licences, and what packages look one another up by."""
_METADATA: Final = ".dist-info/METADATA"
CATALOGUE: Final = ".po"
"""The ending of a catalogue of translations."""
_COMMENT: Final = re.compile(rb"^#.*\n", re.MULTILINE)
"""Of a catalogue of translations: where a sentence stands in the sources."""


def packages(wheel: Path) -> tuple[bytes, dict[str, bytes]]:
    """The archive, with sources without texts, and the compiled libraries by their names; `wheel` is pydantic_core's.

    The page compiles libraries before Python is there, and Python reads none of their bytes.
    """
    files = dict(_own()) | dict(_installed()) | dict(_in_wheel(wheel))
    files = {name: data for name, data in files.items() if not name.endswith(CATALOGUE)}
    libraries = {name: files.pop(name) for name in sorted(files) if name.endswith(".so")}
    made = io.BytesIO()
    with tarfile.open(fileobj=made, mode="w", format=tarfile.USTAR_FORMAT) as archive:
        for name, data in sorted(files.items()):
            # What is put onto boards goes there as it is.
            if name.endswith(".py") and not name.startswith(_ONBOARD):
                data = without_texts(data)
            elif name.endswith(EXERCISE_ENDING):
                # Whoever grades has the exercises; a page is for pupils.
                data = remove_hidden_parts(data, name)
            about = tarfile.TarInfo(name)
            about.size = len(data)
            archive.addfile(about, io.BytesIO(data))
    return made.getvalue(), libraries


def catalogues() -> dict[str, bytes]:
    """The sentences in each language, by the names of their files in the package, packed (zlib): the page fetches those
    of the language that its reader asks for.
    """
    found = dict(_below(_ROOT / "kitrobot" / "translation", "kitrobot/translation"))
    texts = {name: _COMMENT.sub(b"", data) for name, data in found.items() if name.endswith(CATALOGUE)}
    return {name: zlib.compress(data, 9) for name, data in sorted(texts.items())}


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
                data = Path(str(entry.locate())).read_bytes()
                yield inner, _head(data) if inner.endswith(_METADATA) else data


def _in_wheel(wheel: Path) -> Iterator[tuple[str, bytes]]:
    with zipfile.ZipFile(wheel) as archive:
        for name in archive.namelist():
            if not name.endswith(("/", ".pyi", "/RECORD")) and "/sboms/" not in name:
                data = archive.read(name)
                yield name, _head(data) if name.endswith(_METADATA) else data


def _head(metadata: bytes) -> bytes:
    """Names and versions; not the description, which is as long as a book."""
    return re.split(rb"\r?\n\r?\n", metadata, maxsplit=1)[0] + b"\n"
