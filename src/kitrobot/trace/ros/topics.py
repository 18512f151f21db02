"""Names of robots and values as parts of ROS topics: letters, digits and `_`, no digit first."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from typing import Final

_OUR_TOPICS: Final = ("team", "tf", "events", "rosout", "clock", "diagnostics", "kitrobot")
_OTHER = re.compile(r"[^A-Za-z0-9_]+")


def topic_part(name: str) -> str:
    """A name with `_` in the place of what a topic may not have; `_` alone where nothing is left."""
    part = _OTHER.sub("_", name).strip("_")
    return f"_{part}" if part == "" or part[0].isdigit() else part


def distinct_parts(names: Iterable[str]) -> Mapping[str, str]:
    """Of each name the part of a topic that stands for it; two that would be the same get numbers."""
    parts: dict[str, str] = {}
    taken: set[str] = set()
    for name in names:
        part, number = topic_part(name), 2
        while part in taken:
            part, number = f"{topic_part(name)}_{number}", number + 1
        taken.add(part)
        parts[name] = part
    return parts


def robot_parts(robots: Iterable[str]) -> Mapping[str, str]:
    """Of each robot the part of a topic that stands for it. A robot may be called like a topic of ours."""
    return distinct_parts([*_OUR_TOPICS, *robots])
