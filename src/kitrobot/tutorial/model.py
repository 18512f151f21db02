"""A tutorial as it was read: steps, and for each step what has to be so that it is done.

A step wants every one of its `wants`; each of them is a row of patterns of which one is enough. It may want something
of the team (`team`), and something to happen (`events`) while the mission is like that. A step that wants nothing is
read and gone on from.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

from kitrobot.lll.tree import Condition, Failure, Instr, Seq
from kitrobot.primitives.robot import Texts
from kitrobot.xml.lessons import LAST

EVENTS = (
    "run-started",
    "run-done",
    "run-failed",
    "run-ended",
    "saved",
    "edited",
    "member-waits",
    "robot-failed",
    "robot-replaced",
    "robot-dropped",
    "members-shown",
    "projection-shown",
)
"""What can happen in the studio.

A run began; it ended because every program was done; it failed; it ended in any way; the mission was saved; it
was edited. In a team's
run: a member waits for others; a robot failed; another one took over for it; the team goes on without one; the list of
the members was open while one is missed. The projection of the team's program was shown.
"""

Range = tuple[int, int]
PointKind = Literal["part", "vertex", "button", "panel", "program", "group"]


@dataclass(frozen=True)
class Pattern:
    """LLL with holes, and where it has to stand.

    `whole`: it is the whole program; else something of the program. `program` names the one that is meant ("" any);
    `programs` is how many have to be like that. `ranges` says, by hole, which numbers may stand there; how many
    instructions, where the hole is a body; and with 0 as the least that a test may still be missing.
    """

    code: Instr | Condition | Seq
    whole: bool = False
    program: str = ""
    programs: int = 1
    ranges: Mapping[str, Range] = field(default_factory=dict)


@dataclass(frozen=True)
class GroupWant:
    """A group of the team with this rule on failure; `name` is which one, "" any."""

    failure: Failure
    name: str = ""


@dataclass(frozen=True)
class SpareWant:
    """At least so many robots of the team that play no role."""

    robots: int = 1


TeamWant = GroupWant | SpareWant


@dataclass(frozen=True)
class Point:
    """Something of the page that a step points at: `kind` is an attribute of `<point>`, `name` its value.

    `inner` is a setting or a slot of the vertex, or a rule on failure of the group; "" for the vertex or group itself.
    """

    kind: PointKind
    name: str
    inner: str = ""


@dataclass(frozen=True)
class Step:
    """One thing to do: what the person reads, and when it is done."""

    label: Texts
    help: Texts
    hint: Texts
    points: tuple[Point, ...]
    wants: tuple[tuple[Pattern, ...], ...]
    events: tuple[str, ...]
    team: tuple[TeamWant, ...] = ()

    @property
    def asks(self) -> bool:
        """Whether programs or the team have to be in some way."""
        return bool(self.wants or self.team)


@dataclass(frozen=True)
class TeacherPage:
    """What a teacher wants to know of a tutorial: its aim, how long it takes, what goes wrong, what to ask after it."""

    minutes: int
    aim: Texts
    troubles: tuple[Texts, ...] = ()
    questions: tuple[Texts, ...] = ()


@dataclass(frozen=True)
class Tutorial:
    """A tutorial; `start` is the `.krt` beside it that it begins with, `order` its place on the path to learn."""

    start: str
    label: Texts
    help: Texts
    icon: str
    steps: tuple[Step, ...]
    order: int = LAST
    teacher: TeacherPage | None = None
