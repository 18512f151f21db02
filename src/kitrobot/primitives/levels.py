"""The levels of a mission's programs: of one robot, of a group of robots, of all of them."""

from __future__ import annotations

from enum import StrEnum


class Level(StrEnum):
    """Of whom a program speaks. What a level can say the ones behind it can say too."""

    AGENT = "agent"
    GROUP = "group"
    SOCIAL = "social"

    @property
    def is_team(self) -> bool:
        """Whether it is one of several robots."""
        return self is not Level.AGENT

    def holds(self, other: Level) -> bool:
        """Whether what is of another level may stand in a program of this one."""
        return _ORDER[other] <= _ORDER[self]


_ORDER = {level: at for at, level in enumerate(Level)}
