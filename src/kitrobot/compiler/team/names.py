"""Who the names of a team stand for: roles, groups and agents, resolved to roles and agents.

A set is resolved to its *atoms*: the roles and the agents that are named, those of groups among them. Which agents play
a role shows only while a team runs. Where a name is that of a role or a group and of an agent, the former counts.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from typing import NamedTuple, TypeAlias

from kitrobot.compiler.team import rules
from kitrobot.diagnostics.model import Diagnostic, Place
from kitrobot.lll.tree import AnyDeclaration, GroupDeclaration, RoleDeclaration
from kitrobot.primitives.crew import Crew
from kitrobot.primitives.robot import Robot
from kitrobot.text.phrases import listed
from kitrobot.text.sentences import Help, Sentence
from kitrobot.text.suggestions import Suggestions


class Atom(NamedTuple):
    """A role (`is_role`) or an agent, and the kind of robot that it is ("" where that is not known)."""

    is_role: bool
    name: str
    kind: str


Atoms: TypeAlias = frozenset[Atom]
PlaceOf: TypeAlias = Callable[[AnyDeclaration], Place | None]


class Names:
    """The names of a team."""

    def __init__(self, crew: Crew) -> None:
        self.crew = crew
        self.roles = {role.name: role for role in reversed(crew.roles)}
        self.groups = {group.name: group for group in reversed(crew.groups)}
        self.works = {work.name: work for work in reversed(crew.works)}
        self.kinds = dict(crew.agents)
        self.programs = {program.name: program for program in reversed(crew.programs)}
        self.suggestions = Suggestions()

    @cached_property
    def members(self) -> list[str]:
        """Every name that a set may hold."""
        return list(dict.fromkeys([*self.roles, *self.groups, *self.kinds]))

    def atom(self, name: str) -> Atoms:
        """A role or an agent as a set; empty where there is none of that name."""
        if name in self.roles:
            return frozenset((Atom(True, name, self.roles[name].robot),))
        return frozenset((Atom(False, name, self.kinds[name]),)) if name in self.kinds else frozenset()

    def atoms(self, names: Iterable[str]) -> Atoms:
        """The roles and agents that a set stands for; unknown names stand for nobody."""
        of_groups = self._of_groups
        found = [of_groups[name] if name in of_groups else self.atom(name) for name in names]
        return frozenset().union(*found)

    @cached_property
    def _of_groups(self) -> dict[str, Atoms]:
        """The roles and agents that each group stands for; of those that hold each other, all the same."""
        found: dict[str, Atoms] = {}
        inside = {name: group.members.names for name, group in self.groups.items() if name not in self.roles}
        inside = {name: members for name, members in inside.items() if members}
        for part in reversed(_components(inside)):
            members = [one for name in part for one in inside[name]]
            atoms = [found.get(one, frozenset()) if one in inside else self.atom(one) for one in members]
            found.update(dict.fromkeys(part, frozenset().union(*atoms)))
        return found

    def fewest(self, name: str) -> int:
        """How many members a role or a group has at least."""
        return sum(self.roles[one.name].least if one.is_role else 1 for one in self.atoms((name,)))

    def unknown(self, name: str) -> tuple[Sentence, Help] | None:
        """What is wrong with a name in a set, and a way out; None where it is right."""
        if name in self.roles or name in self.groups or name in self.kinds:
            return None
        if name in self.works:
            return (
                Sentence("`{name}` is work, and a set holds roles, groups and agents", name),
                Sentence("ask the work itself, as in {work}.IsEmpty()", name),
            )
        near = self.suggestions.did_you_mean(name, self.members)
        declare = Sentence("declare it: role {name}: …", name)
        known = Sentence("there is {known}", listed(self.members)) if self.members else declare
        return Sentence("the team has no role, no group and no agent `{name}`", name), near or known

    @cached_property
    def in_circles(self) -> frozenset[str]:
        """The groups that hold themselves."""
        inside = {name: group.members.names for name, group in self.groups.items()}
        parts = [part for part in _components(inside) if len(part) > 1 or part[0] in inside[part[0]]]
        return frozenset(name for part in parts for name in part)


def _components(inside: Mapping[str, Sequence[str]]) -> list[list[str]]:
    """Groups that hold each other, together; whoever holds others comes before those. Linear (Kosaraju's algorithm)."""
    holders: defaultdict[str, list[str]] = defaultdict(list)
    for name, members in inside.items():
        for one in members:
            if one in inside:
                holders[one].append(name)
    held = {name: [one for one in members if one in inside] for name, members in inside.items()}
    ended = [name for part in _parts(held, held) for name in part]
    return list(_parts(reversed(ended), holders))


def _parts(begins: Iterable[str], following: Mapping[str, Iterable[str]]) -> Iterator[list[str]]:
    """What is reached from each beginning and not from an earlier one, in the order in which a search leaves it."""
    seen = set[str]()
    for begin in begins:
        part, ways = list[str](), [(begin, iter((begin,)))]
        while ways:
            name, way = ways[-1]
            new = next((one for one in way if one not in seen), None)
            if new is not None:
                seen.add(new)
                ways.append((new, iter(following.get(new, ()))))
            else:
                ways.pop()
                part += [name] if ways else []
        if part:
            yield part


def check_declarations(crew: Crew, robots: Mapping[str, Robot], place_of: PlaceOf) -> list[Diagnostic]:
    """What is wrong with what a team declares; `place_of` says where a declaration stands."""
    names = Names(crew)
    found: list[Diagnostic] = []
    seen: set[str] = set()
    declarations: list[AnyDeclaration] = [*crew.roles, *crew.groups, *crew.works]
    for declaration in declarations:
        if declaration.name in seen:
            message = Sentence("`{name}` is declared already", declaration.name)
            found.append(rules.SAME_NAME(message, place_of(declaration), help=Sentence("choose another name")))
        seen.add(declaration.name)
    for role in crew.roles:
        if (told := _unplayed(role, crew, robots, names.suggestions)) is not None:
            found.append(rules.UNPLAYED(told[0], place_of(role), help=told[1]))
    failures: defaultdict[Atom, set[str]] = defaultdict(set)
    for group in crew.groups:
        for atom in names.atoms((group.name,)):
            failures[atom].add(group.failure)
    for group in crew.groups:
        known = all(names.unknown(name) is None for name in group.members.names)
        for name in group.members.names:
            if (told := names.unknown(name)) is not None:
                found.append(rules.UNKNOWN_MEMBER(told[0], place_of(group), help=told[1]))
        if group.name in names.in_circles:
            message = Sentence("the group `{group}` holds itself", group.name)
            help = Sentence("take it out of its members, or of theirs")
            found.append(rules.GROUP_CIRCLE(message, place_of(group), help=help))
        elif known and not names.fewest(group.name):
            message = Sentence("the group `{group}` may have no member", group.name)
            help = Sentence("let a role of it want at least one robot, or name an agent")
            found.append(rules.GROUP_EMPTY(message, place_of(group), help=help))
        elif known and (told := _emptied(group, names, failures)) is not None:
            found.append(rules.GROUP_EMPTY(told[0], place_of(group), help=told[1]))
    return found


def _emptied(group: GroupDeclaration, names: Names, failures: Mapping[Atom, set[str]]) -> tuple[Sentence, Help] | None:
    """What one failure does to a group of a single robot, and a way out; None where it is not left empty by it.

    `failures`: what the groups that hold a role or an agent say of its failure.
    """
    players = dict(zip((role.name for role in names.crew.roles), names.crew.players, strict=True))
    atoms = names.atoms((group.name,))
    if sum(players[one.name] if one.is_role else 1 for one in atoms) != 1:
        return None
    one = next(one for one in atoms if not one.is_role or players[one.name])
    if "abort" in failures[one] or ("substitute" in failures[one] and names.crew.spare(one.kind) > 0):
        return None
    message = Sentence("the group `{group}` has one robot, and none when that one fails", group.name)
    if "substitute" in failures[one]:
        return message, Sentence("add a spare robot of its kind, or write `on failure abort`")
    return message, Sentence("write `on failure substitute`, with a spare robot of its kind, or `on failure abort`")


def _unplayed(
    role: RoleDeclaration, crew: Crew, robots: Mapping[str, Robot], suggestions: Suggestions
) -> tuple[Sentence, Help] | None:
    """Why nobody can play a role, and a way out; None where somebody can."""
    if role.robot not in robots:
        return (
            Sentence("the role `{role}` is for the robot `{robot}`, which is not at hand", role.name, role.robot),
            suggestions.did_you_mean(role.robot, robots)
            or Sentence("robots at hand: {robots}", listed(robots) if robots else "—"),
        )
    able = sum(kind in ("", role.robot) for _, kind in crew.agents)
    if able >= max(role.least, 1):
        return None
    return (
        Sentence(
            "the role `{role}` wants {least} of the robot `{robot}`, and the team has {found}",
            role.name,
            max(role.least, 1),
            role.robot,
            able,
        ),
        Sentence("add agents whose program is for that robot, or want fewer"),
    )
