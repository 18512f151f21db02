"""The points of a team's program: numbered places at which its robots agree, the same for all of them.

A projected program (`projection`) names points by number, in calls of the robot object `Team`; the host of a team, the
simulator or a fleet, has this list and knows what each call asks for:

- *block* and *branch*: whether this robot is one of `members` and does what follows; nobody waits for anybody;
- *meet*: all of `members` come here before one of them goes on;
- *ask*: all of `members` come here, and the answers of those of them that are `asked` are combined, once for all;
- *count*: all of `members` come here, with 0 before a loop and with 1 after each pass; yes `times` times, then no;
- *move*: all of `members` come here, and `times` robots go over from one group to another.

A substitute runs its program from the beginning and is led to the outermost block in which its role was lost, or to the
last point that this role came to in no block: until then *meet* and *move* are over at once, and the others are yes
exactly where that point lies within `leads`. So what is done already is passed over, and each loop and choice around
that point is entered. In the block it is told again what was agreed there since the block began.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum
from typing import Final, Literal

from kitrobot.lll.tree import Quantifier

NameSet = frozenset[str]
"""Roles, groups and agents as a program names them; none of them stand for the whole team."""

ALL: NameSet = frozenset()
"""The whole team."""

ONE: Final = "one"
"""The answer of one robot counts: of what all of them know alike."""


class PointKind(StrEnum):
    """What is done at a point."""

    BLOCK = "block"
    BRANCH = "branch"
    MEET = "meet"
    ASK = "ask"
    COUNT = "count"
    MOVE = "move"


@dataclass(frozen=True, slots=True)
class Point:
    """A point of a team's program.

    Attributes:
        kind: what is done there.
        members: whose robots come there.
        asked: of those, whose answers count (*ask*).
        quantifier: how answers are combined; `ONE` takes the first member's.
        negated: whether the combined answer is turned round.
        times: passes of *count*, robots of *move*.
        moves: of *move*, the group that is left and the one that is joined.
        leads: the points, first and last, that are reached by a yes; (0, -1) for none.
        program: the team's program in which it stands.
        vertex: the vertex there, None where it came from no graph.
    """

    kind: PointKind
    members: NameSet
    asked: NameSet = frozenset()
    quantifier: Quantifier | Literal["one"] = ONE
    negated: bool = False
    times: int = 0
    moves: tuple[str, str] = ("", "")
    leads: tuple[int, int] = (0, -1)
    program: str = ""
    vertex: str | None = None


@dataclass(frozen=True, slots=True)
class TeamPlan:
    """What the host of a team knows of its program: `points[n]` is point n, `groups` is what each group begins with.

    A role that robots move from or to is a group too, with itself in it.
    """

    points: tuple[Point, ...]
    groups: Mapping[str, NameSet]
