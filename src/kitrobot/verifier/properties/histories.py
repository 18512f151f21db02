"""Searches the stored steps of a state space for a shortest run whose history breaks a property.

What a history remembers is one small number beside each state. Both together are searched breadth-first, so no state is
explored anew, and other properties pay nothing for it.
"""

from __future__ import annotations

from array import array
from typing import Final

from kitrobot.verifier.exploration.exploration import StateSpace
from kitrobot.verifier.properties.fair_cycles import mark_states
from kitrobot.verifier.properties.properties import BROKEN, KEPT, History

HISTORY_BYTES: Final = 17
"""For each state and memory: the pair, where it came from, and whether it was seen."""
_PAUSE: Final = 20_000
"""Pairs between two polls of the limits."""


def find_broken_history(space: StateSpace, history: History) -> list[int]:
    """The states of a shortest run that breaks a property by its history, from the first state on.

    Empty if there is none, or if the search ended early (`StateSpace.interrupted_by`).
    """
    space.interrupted_by = space.interrupted_by or space.interruption()
    if not len(space) or space.interrupted_by:
        return []
    marks = []
    for condition in history.conditions:
        marks.append(mark_states(space, condition)[0])
        if space.interruption():
            # Of the rest of the states nothing is known.
            space.interrupted_by = space.interruption()
            return []
    return _Search(space, history, marks).find()


class _Search:
    """Pairs of a state and a memory, in the order of their discovery; `_parents` are places in that order."""

    def __init__(self, space: StateSpace, history: History, marks: list[bytearray]) -> None:
        self._space, self._history, self._marks = space, history, marks
        self._pairs, self._parents = array("q"), array("q")
        self._seen = bytearray(len(space) * history.size)
        self._known: dict[tuple[int, tuple[bool, ...], tuple[bool, ...]], int] = {}

    def find(self) -> list[int]:
        """The states of a shortest run that breaks the property; empty for none."""
        space, size = self._space, self._history.size
        nothing = (False,) * len(self._marks)
        if self._come(0, 0, nothing, -1):
            return [0]
        first_edge, targets, at = space.graph.first_edge, space.graph.targets, 0
        while at < len(self._pairs):
            if at % _PAUSE == 0 and (cut := space.interruption()):
                space.interrupted_by = cut
                return []
            state, memory = divmod(self._pairs[at], size)
            if state < space.expanded:
                before = self._truths(state)
                for target in targets[first_edge[state] : first_edge[state + 1]]:
                    if self._come(int(target), memory, before, at):
                        return [*self._path(at), int(target)]
            at += 1
        return []

    def _come(self, state: int, memory: int, before: tuple[bool, ...], parent: int) -> bool:
        """Comes to a state with a memory; whether that breaks the property."""
        now = self._truths(state)
        key = memory, before, now
        following = self._known.get(key)
        if following is None:
            comes = tuple(one and not was for one, was in zip(now, before, strict=True))
            following = self._known[key] = self._history.step(memory, now, comes)
        if following in (BROKEN, KEPT):
            return following == BROKEN
        pair = state * self._history.size + following
        if not self._seen[pair]:
            self._seen[pair] = 1
            self._pairs.append(pair)
            self._parents.append(parent)
        return False

    def _truths(self, state: int) -> tuple[bool, ...]:
        return tuple(bool(marks[state]) for marks in self._marks)

    def _path(self, at: int) -> list[int]:
        found = []
        while at >= 0:
            found.append(self._pairs[at] // self._history.size)
            at = self._parents[at]
        return found[::-1]
