"""Who can ever be in the sets of a team's program: MOVE takes robots from one group to another while it runs."""

from __future__ import annotations

from collections.abc import Iterable

from kitrobot.compiler.team.names import Atoms, Names
from kitrobot.lll.tree import Move, Seq
from kitrobot.lll.walk import nodes
from kitrobot.primitives.crew import Crew


class TeamSets:
    """The roles, groups and agents of a team, and where the robots of a program move. Unknown names are nobody."""

    def __init__(self, crew: Crew, program: Seq) -> None:
        self._names = Names(crew)
        self._joining: dict[str, set[str]] = {}
        for node in nodes(program):
            if isinstance(node, Move):
                self._joining.setdefault(str(node.target), set()).add(str(node.source))

    @property
    def groups(self) -> dict[str, frozenset[str]]:
        """What each group begins with; a role that robots move from or to is a group of its own, too."""
        declared = {name: frozenset(group.members.names) for name, group in self._names.groups.items()}
        moved = sorted({*self._joining, *(source for sources in self._joining.values() for source in sources)})
        return {**{name: frozenset((name,)) for name in moved if name in self._names.roles}, **declared}

    def first_members(self, names: Iterable[str]) -> Atoms:
        """The roles and agents of a set before anybody moves."""
        return self._names.atoms(names)

    def kinds(self, names: Iterable[str]) -> frozenset[str]:
        """The kinds of robots that can ever be in a set; of no names, those of the whole team."""
        names = list(names)
        if not names:
            return frozenset(kind for _, _, kind in self._names.atoms(self._names.members) if kind)
        return frozenset(kind for _, _, kind in self.ever(names) if kind)

    def ever(self, names: Iterable[str]) -> Atoms:
        """The roles and agents whose robots can ever be in a set."""
        waiting, seen, found = list(names), set(names), Atoms()
        while waiting:
            name = waiting.pop()
            found |= self._names.atom(name)
            group = self._names.groups.get(name)
            inside = {*(group.members.names if group is not None else ()), *self._joining.get(name, ())} - seen
            seen |= inside
            waiting += inside
        return found
