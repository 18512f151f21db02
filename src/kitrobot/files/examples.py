"""The missions that come with KitRobot: beside the package when it is installed, in `examples/` of a checkout."""

from __future__ import annotations

from pathlib import Path

_PACKAGE = Path(__file__).resolve().parent.parent

FIRST = "transport/transport.krt"
"""What the studio opens with when nothing is named."""


def examples_folder() -> Path | None:
    """The folder of the examples; None when this installation has none."""
    for folder in (_PACKAGE / "examples", _PACKAGE.parent.parent / "examples"):
        if folder.is_dir():
            return folder
    return None


def find_mission(path: Path) -> Path:
    """The mission that a relative path names: the file of that name, else the example of that name.

    An example is named as in a checkout (`examples/heart/heart.krt`), by its place among the examples
    (`heart/heart.krt`) or by its name alone (`heart`). A path that names neither is returned as it is.
    """
    folder = examples_folder()
    if folder is None or path.is_absolute() or path.exists() or ".." in path.parts:
        return path
    name = path.as_posix().removeprefix("examples/").removesuffix(".krt")
    for place in (name, f"{name}/{name}"):
        found = folder / f"{place}.krt"
        if found.is_file():
            return found
    return path


def first_example() -> Path | None:
    """The mission to begin with, or None."""
    folder = examples_folder()
    if folder is None:
        return None
    path = folder / FIRST
    if path.is_file():
        return path
    return next(iter(sorted(folder.glob("*/*.krt"))), None)
