"""Which programs of a mission are the same under another name."""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass

from kitrobot.graph.model import START, STOP, Program
from kitrobot.mission.model import Mission

_ALIKE = 0.6
"""So much of two programs' vertices must be the same for one to be the other renamed."""

_MOST_COMPARED = 1_000_000
"""Vertices that are held against others to find renamed programs; where it would be more, only equal ones are found."""


def renamed_programs(before: Mission, after: Mission) -> dict[str, str]:
    """Old name → new name of the programs that only go by another name, as far as what they hold tells."""
    old_names = {program.name for program in before.programs}
    new_names = {program.name for program in after.programs}
    gone = [_marks(program) for program in before.programs if program.name not in new_names]
    free = [_marks(program) for program in after.programs if program.name not in old_names]
    if sum(len(one.marks) for one in gone) * len(free) + len(gone) * len(free) > _MOST_COMPARED:
        return _renamed_as_they_are(gone, free)
    found: dict[str, str] = {}
    for one in gone:
        if not free:
            break
        best = max(free, key=one.likeness)
        if one.likeness(best) >= _ALIKE:
            found[one.name] = best.name
            free.remove(best)
    return found


def _renamed_as_they_are(gone: Sequence[_Marks], free: Sequence[_Marks]) -> dict[str, str]:
    """Of very many programs only those that hold the very same."""
    names: dict[object, deque[str]] = {}
    for one in free:
        names.setdefault(one.key, deque()).append(one.name)
    return {one.name: names[one.key].popleft() for one in gone if names.get(one.key)}


@dataclass(frozen=True, eq=False)
class _Marks:
    """A program by what it holds: the ids and elements of its vertices."""

    name: str
    robot: str
    marks: frozenset[tuple[str, str]]

    @property
    def key(self) -> object:
        """Equal for programs that are wholly alike."""
        return self.marks or self.robot

    def likeness(self, other: _Marks) -> float:
        """How alike two programs are, 0 to 1."""
        if not self.marks and not other.marks:
            return float(self.robot == other.robot)
        return len(self.marks & other.marks) / max(len(self.marks), len(other.marks))


def _marks(program: Program) -> _Marks:
    marks = ((vertex.id, vertex.element) for vertex in program.vertices if vertex.element not in (START, STOP))
    return _Marks(program.name, program.target, frozenset(marks))
