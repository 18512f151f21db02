"""The slots and parallels of a program, numbered in reading order before any code is written.

Slot 0 is the program; then each branch, followed by what is nested in it. What stands in a loop of 0 times is never
compiled and gets no number; a mark there still marks its branch, because marks are a matter of the text.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

from kitrobot.image.model import ParallelRecord
from kitrobot.lll.tree import Call, Interrupt, Parallel, Repeat, Seq, Wait
from kitrobot.lll.walk import bodies


@dataclass
class Branch:
    """A slot while it is compiled."""

    seq: Seq
    parallel: int | None
    marked: bool
    end: int = 0
    entry: int = 0


@dataclass
class SlotTree:
    """The slots and parallels of a program, numbered in reading order."""

    slots: list[Branch] = field(default_factory=list)
    parallels: list[ParallelRecord] = field(default_factory=list)
    number: dict[int, int] = field(default_factory=dict)

    def add(self, seq: Seq, parallel: int | None, *, marked: bool) -> None:
        """Numbers a slot and all that is nested in it."""
        slot = len(self.slots)
        branch = Branch(seq, parallel, marked)
        self.slots.append(branch)
        for node in _parallels(seq):
            number = self.number[id(node)] = len(self.parallels)
            self.parallels.append(ParallelRecord(slot, len(self.slots), 0))
            for inner in node.branches:
                self.add(inner, number, marked=is_marked(inner))
            self.parallels[number] = self.parallels[number]._replace(end=len(self.slots))
        branch.end = len(self.slots)


def _parallels(seq: Seq) -> Iterator[Parallel]:
    """The parallels of a slot, in reading order, those that are never compiled left out; not what is nested in them."""
    for node in seq.items:
        if isinstance(node, Parallel):
            if node.branches:
                yield node
        elif not isinstance(node, Call | Wait) and not (isinstance(node, Repeat) and node.count == 0):
            for body in bodies(node):
                yield from _parallels(body)


def is_marked(seq: Seq) -> bool:
    """Whether a branch holds a marked action of its own (those of nested parallels mark their own branches)."""
    return any(
        isinstance(node, Interrupt)
        or (not isinstance(node, Parallel) and any(is_marked(body) for body in bodies(node)))
        for node in seq.items
    )
