"""A tutorial as it was read: steps, and for each step what has to be so that it is done.

A step wants every one of its `wants`; each of them is a row of patterns of which one is enough. It may also want
something to happen (`events`) while the program is like that. A step that wants nothing is read and gone on from.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

from kitrobot.lll import Condition, Instr, Seq
from kitrobot.primitives import Texts

EVENTS = ("run-started", "run-done", "run-ended", "saved")
"""What can happen in the studio: a run began; it ended because every program was done; it ended in any way; the
mission was saved.
"""

Range = tuple[int, int]
PointKind = Literal["part", "vertex", "button", "panel", "program"]


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
class Point:
    """Something of the page that a step points at: `kind` is an attribute of `<point>`, `name` its value.

    `inner` is a setting or a slot of the vertex that is pointed at; "" for the vertex itself.
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


@dataclass(frozen=True)
class Tutorial:
    """A tutorial; `start` is the `.krt` beside it that it begins with."""

    start: str
    label: Texts
    help: Texts
    icon: str
    steps: tuple[Step, ...]
