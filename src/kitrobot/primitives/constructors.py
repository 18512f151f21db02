"""A program constructor as its XML describes it: slots, and LLL with holes.

Nothing here knows any one constructor: what a constructor means is its `template`, an LLL tree whose holes are the
constructor's slots. Left to others: reading the XML (constructors_xml), filling and inverting templates (compiler).
"""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import StrEnum
from functools import cached_property
from typing import Literal

from kitrobot.lll.tree import And, Condition, Instr, Or, Seq
from kitrobot.lll.walk import nodes
from kitrobot.primitives.levels import Level
from kitrobot.primitives.meaning import Meaning
from kitrobot.primitives.robot import LAST_PLACE, SearchWords, Texts


class SlotKind(StrEnum):
    """What fills a slot: a chain of vertices, one test, a number or value vertex, typed text, one procedure call."""

    FLOW = "flow"
    CONDITION = "condition"
    VALUE = "value"
    NUMBER = "number"
    TEXT = "text"
    ACTION = "action"


class Role(StrEnum):
    """Where a constructor stands: as an instruction, as a condition, or as one more branch of another."""

    INSTRUCTION = "instruction"
    CONDITION = "condition"
    BRANCH = "branch"


@dataclass(frozen=True)
class Slot:
    """A hole of a constructor. A `repeat` slot holds any number of bodies; `least` of them come with a new vertex.

    `names` says what a text slot names: "set" (roles, groups and agents) or "program"; "" for anything else.
    """

    name: str
    kind: SlotKind
    loop: bool = False
    repeat: bool = False
    least: int = 0
    minimum: int | None = field(default=None, metadata={"alias": "min"})
    maximum: int | None = field(default=None, metadata={"alias": "max"})
    default: str = ""
    unit: str = ""
    label: Texts = field(default_factory=dict)
    names: Literal["", "set", "program"] = ""
    meaning: Meaning | None = None


@dataclass(frozen=True)
class Constructor:
    """A building block. `template` is None exactly for one that only adds a branch (`adds`: constructor, slot).

    It stands in programs of its `level` and of those behind it.
    `reads` are other templates with the same slots: LLL made from one is drawn as this constructor too.
    `order` is its place under its heading of the palette; `words` find it there.
    """

    name: str
    group: str
    colour: str
    slots: tuple[Slot, ...]
    code: str
    template: Instr | Condition | Seq | None
    role: Role
    adds: tuple[str, str] | None = None
    icon: str = ""
    label: Texts = field(default_factory=dict)
    help: Texts = field(default_factory=dict)
    reads: tuple[Instr | Condition, ...] = ()
    level: Level = Level.AGENT
    order: int = LAST_PLACE
    words: SearchWords = field(default_factory=dict)

    def slot(self, name: str) -> Slot | None:
        """The slot of that name, or None."""
        return self._slots.get(name)

    @cached_property
    def _slots(self) -> dict[str, Slot]:
        return {slot.name: slot for slot in self.slots}

    @cached_property
    def size(self) -> int:
        """Instructions and tests that a vertex of it becomes, without what is in its slots: at least so many rows of an
        image, or an eighth of the nodes of a tree.
        """
        if self.template is None:
            return 0
        made = nodes(self.template)
        tests = sum(isinstance(node, And | Or) for node in made)
        rows = sum(len(node.items) for node in made if isinstance(node, Seq)) + (not isinstance(self.template, Seq))
        return max(len(made) // 8, rows + tests)


@dataclass(frozen=True)
class Group:
    """A tab of the palette and its constructors. `holds` says which parts of a robot that name no group are there."""

    name: str
    colour: str
    constructors: tuple[Constructor, ...]
    label: Texts = field(default_factory=dict)
    icon: str = ""
    holds: str = ""
