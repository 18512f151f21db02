"""Which file a world's name in a mission means: the mission's folder first, then others, then what is shipped."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from kitrobot.diagnostics.regular import named_file

SUFFIX = ".world.xml"

SHIPPED = Path(__file__).parent / "shipped"
"""The worlds that come with KitRobot."""

EMPTY = "empty" + SUFFIX
"""What a mission without a world means."""


def find_world(href: str, folders: Sequence[Path] = ()) -> Path | None:
    """The file for a mission's `href`, or None.

    Args:
        href: a file's name such as `ring.world.xml`; "" means the empty world. A path that leads out of its folder is
            never followed.
        folders: where to look before the shipped worlds, the most particular one first.
    """
    name = href or EMPTY
    if "\\" in name or "\0" in name or name.startswith("/") or ".." in name.split("/"):
        return None
    for folder in [*folders, SHIPPED]:
        path = named_file(folder, name)
        if path is not None:
            return path
    return None
