"""What a site needs and no installation has: Pyodide, and the wheel of pydantic_core that was compiled for it.

Both are in the package `kitrobot_site_parts`, whose wheel is made beside KitRobot's own; folders with them can be named
instead.
"""

from __future__ import annotations

import importlib.util
import json
from collections.abc import Iterable, Sequence
from importlib.metadata import version
from pathlib import Path
from typing import Final

from kitrobot import __version__
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.text.sentences import Sentence

PYODIDE: Final = "314.0.7"
"""The version of Pyodide; its Python and its ABI are those of the wheel."""
PYTHON: Final = "3.14"
WHEEL_TAGS: Final = "cp314-cp314-pyemscripten_2026_0_wasm32"
INSTALLED: Final = "kitrobot_site_parts"
"""The package that brings the parts."""

LIBRARY: Final = "python_stdlib.zip"
LARGE: Final = ("pyodide.asm.wasm", LIBRARY)
LOCK: Final = "pyodide-lock.json"
RUNTIME: Final = ("pyodide.mjs", "pyodide.asm.mjs", *LARGE, LOCK)
"""The files of Pyodide that a site needs."""


class SiteError(KitRobotError):
    """The site cannot be made."""


def find_parts(named: Iterable[Path] = ()) -> tuple[Path, Path]:
    """The folder of Pyodide, and pydantic_core's wheel for it: in folders that were named, or as they are installed.

    Raises:
        SiteError: one is not there, or is of another version.
    """
    places = [*named, *_installed()]
    return _pyodide_in(places), _wheel_in(places)


def _installed() -> list[Path]:
    spec = importlib.util.find_spec(INSTALLED)
    return [Path(place) for place in spec.submodule_search_locations or ()] if spec is not None else []


def _help() -> Sentence:
    return Sentence(
        "install the wheel `{wheel}`, which is made beside KitRobot's own: it has all that a site needs",
        f"{INSTALLED}-{__version__}-py3-none-any.whl",
    )


def _pyodide_in(places: Sequence[Path]) -> Path:
    found = ""
    for place in places:
        for folder in (place, place / "pyodide", place / "node_modules" / "pyodide"):
            try:
                package = json.loads((folder / "package.json").read_bytes())
            except (OSError, ValueError):
                continue
            if not isinstance(package, dict) or package.get("name") != "pyodide":
                continue
            found = str(package.get("version"))
            if found == PYODIDE and all((folder / name).is_file() for name in RUNTIME):
                return folder
    if found:
        raise SiteError(Sentence("Pyodide {found} is here, and {wanted} is needed", found, PYODIDE), _help())
    raise SiteError(Sentence("Pyodide is not here: the Python that runs in a page"), _help())


def _wheel_in(places: Sequence[Path]) -> Path:
    wanted = f"pydantic_core-{version('pydantic_core')}-{WHEEL_TAGS}.whl"
    found = next((place / wanted for place in places if (place / wanted).is_file()), None)
    if found is not None:
        return found
    message = Sentence("the wheel `{wheel}` is not here, which was compiled for Pyodide", wanted)
    other = next((path for place in places for path in sorted(place.glob(f"pydantic_core-*-{WHEEL_TAGS}.whl"))), None)
    if other is None:
        raise SiteError(message, _help())
    # A dependency of KitRobot was renewed since the parts were made.
    there = other.name.split("-")[1]
    help = Sentence("that of pydantic_core {version} is here: `pip install pydantic_core=={version}`", there)
    raise SiteError(message, help)
