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


def first_example() -> Path | None:
    """The mission to begin with, or None."""
    folder = examples_folder()
    if folder is None:
        return None
    path = folder / FIRST
    if path.is_file():
        return path
    return next(iter(sorted(folder.glob("*/*.krt"))), None)
