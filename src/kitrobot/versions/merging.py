"""Two people's edits of one mission brought together: a three-way merge by programs, vertices and arcs.

What only one side changed is taken from it. In a program each out-port leads to one place, so two edits of different
places change different ports and both stand; ids that both sides gave to different new vertices are made fresh first.
Where both changed the same thing differently ours stays, unless theirs was decided on, and a sentence says so. A
program whose merged graph would not hang together as both sides' graphs do stays whole as ours, and that is said too.
So the result is always a mission that opens. Left to others: what the sentences are written to.
"""

from __future__ import annotations

from collections.abc import Collection, Hashable, Iterable, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from typing import Any

from kitrobot.graph import IN, RETURN, START, STOP, Arc, Program, Vertex
from kitrobot.mission import Agent, Breakpoint, Failure, Goal, Mission, Team
from kitrobot.primitives import Constructor, OwnVariable
from kitrobot.text import Sentence, Word
from kitrobot.versions.comparison import renamed_programs
from kitrobot.versions.conflicts import Conflict, Decisions
from kitrobot.versions.lists import merged_by_name, merged_order
from kitrobot.versions.outline import Outline
from kitrobot.versions.own_worlds import merge_places
from kitrobot.versions.wording import named

Port = tuple[str, str]


@dataclass(frozen=True)
class Merged:
    """What became of it, and what both changed differently."""

    mission: Mission
    clashes: tuple[Conflict, ...] = ()

    @property
    def conflicts(self) -> tuple[str, ...]:
        """A sentence for each."""
        return tuple(one.sentence for one in self.clashes)


def merge_missions(base: Mission, ours: Mission, theirs: Mission, taken: Collection[str] = ()) -> Merged:
    """The mission with both sides' edits of `base`; `taken` are the names of conflicts in which theirs is taken."""
    if theirs in (base, ours):
        return Merged(ours)
    if ours == base:
        return Merged(theirs)
    decisions = Decisions(taken)
    choose = decisions.choose
    programs = _programs(base, ours, theirs, decisions)
    agents = merged_by_name(*_with_new_names(base, ours, theirs), _agent_name, Sentence("the agent"), choose)
    _bring_back(programs, agents, (ours, theirs), decisions)
    goals = merged_by_name(
        base.team.goals, ours.team.goals, theirs.team.goals, _goal_name, Sentence("the goal of"), choose
    )
    own: dict[str, Any] = {
        "constructors": merged_by_name(
            base.constructors, ours.constructors, theirs.constructors, _own_name, Sentence("the own part"), choose
        ),
        "breakpoints": merged_by_name(
            base.breakpoints,
            ours.breakpoints,
            theirs.breakpoints,
            _breakpoint_name,
            Sentence("the breakpoint at"),
            choose,
        ),
        "failures": merged_by_name(
            base.failures, ours.failures, theirs.failures, _failure_name, Sentence("the failure of"), choose
        ),
        "properties": merged_by_name(
            base.properties, ours.properties, theirs.properties, _declared, Sentence("the property"), choose
        ),
        "variables": merged_by_name(
            base.variables, ours.variables, theirs.variables, _own_name, Sentence("the variable"), choose
        ),
    }
    rest = {
        field.name: choose(
            Sentence("the {field} of the mission", Word(field.name)),
            getattr(base, field.name),
            getattr(ours, field.name),
            getattr(theirs, field.name),
        )
        for field in fields(Mission)
        if field.name not in ("programs", "team", "world_href", "own_world", *own)
    }
    href, own["own_world"] = merge_places(base, ours, theirs, merged_by_name, choose)
    team = Team(agents, goals)
    for what, word in (
        ("roles", Sentence("the role")),
        ("groups", Sentence("the group")),
        ("works", Sentence("the work")),
    ):
        old, mine, other = (getattr(side.team, what) for side in (base, ours, theirs))
        setattr(team, what, merged_by_name(old, mine, other, _declared, word, choose))
    mission = Mission(programs=programs, team=team, world_href=href, **own, **rest)
    return Merged(mission, tuple(decisions.found))


def _with_new_names(base: Mission, ours: Mission, theirs: Mission) -> tuple[list[Agent], list[Agent], list[Agent]]:
    """The three teams, each agent with the newest name of its program."""
    names = {**renamed_programs(base, theirs), **renamed_programs(base, ours)}
    old, mine, other = (
        [replace(agent, program=names.get(agent.program, agent.program)) for agent in side.team.agents]
        for side in (base, ours, theirs)
    )
    return old, mine, other


def _bring_back(
    programs: list[Program], agents: Sequence[Agent], sides: Iterable[Mission], decisions: Decisions
) -> None:
    """Programs that one side removed and that the other's agents run."""
    have = {program.name for program in programs}
    for side in sides:
        known = {program.name: program for program in reversed(side.programs)}
        for name in dict.fromkeys(agent.program for agent in agents):
            found = known.get(name)
            if found is not None and name not in have:
                programs.append(found)
                have.add(name)
                words = Sentence(
                    "the program {program} was removed in one and runs on an agent of the other: it is kept", name
                )
                decisions.tell(Sentence("the program {program}", name), words)


def _agent_name(agent: Agent) -> Hashable:
    return agent.name


def _goal_name(goal: Goal) -> Hashable:
    return goal.storehouse


def _declared(declaration: Any) -> Hashable:
    name: str = declaration.name
    return name


def _breakpoint_name(breakpoint: Breakpoint) -> Hashable:
    return (breakpoint.program, breakpoint.vertex, breakpoint.agents)


def _failure_name(failure: Failure) -> Hashable:
    return (failure.agent, failure.at_s)


def _own_name(own: Constructor | OwnVariable) -> str:
    return own.name if isinstance(own, Constructor) else f"{own.robot}.{own.variable.name}"


def _programs(base: Mission, ours: Mission, theirs: Mission, decisions: Decisions) -> list[Program]:
    our_names, their_names = renamed_programs(base, ours), renamed_programs(base, theirs)
    old = {program.name: program for program in base.programs}
    mine = _by_old_name(ours, our_names)
    other = _by_old_name(theirs, their_names)
    found: list[Program] = []
    for name in merged_order(old, mine, other):
        one, two, three = old.get(name), mine.get(name), other.get(name)
        if two is not None and three is not None:
            merged = _program(one or Program(two.name, two.target, level=two.level), two, three, decisions)
            found.append(replace(merged, name=_side(name, two.name, three.name)))
        elif two is not None:
            if two != one and (one is None or not _goes(two.name, decisions)):
                found.append(two)
        elif three is not None and three != one and (one is None or _comes_back(name, decisions)):
            found.append(three)
    return list({program.name: program for program in reversed(found)}.values())[::-1]


def _goes(name: str, decisions: Decisions) -> bool:
    """Whether a program goes that they removed and we changed."""
    return decisions.takes(
        Sentence("the program {program}", name),
        Sentence("the program {program} was removed by them and changed by us: ours is kept", name),
        Sentence("the program {program} was removed by them and changed by us: it is removed", name),
    )


def _comes_back(name: str, decisions: Decisions) -> bool:
    """Whether a program is back that we removed and they changed."""
    return decisions.takes(
        Sentence("the program {program}", name),
        Sentence("the program {program} was removed by us and changed by them: ours is kept", name),
        Sentence("the program {program} was removed by us and changed by them: theirs is taken", name),
    )


def _by_old_name(mission: Mission, renamed: Mapping[str, str]) -> dict[str, Program]:
    was = {new: old for old, new in renamed.items()}
    return {was.get(program.name, program.name): program for program in mission.programs}


def _side(base: str, ours: str, theirs: str) -> str:
    return theirs if ours == base else ours


def _program(base: Program, ours: Program, theirs: Program, decisions: Decisions) -> Program:
    """Both sides' edits of one program; its name is ours."""
    same = replace(theirs, name=base.name)
    if same in (base, replace(ours, name=base.name)):
        return ours
    if replace(ours, name=base.name) == base:
        return replace(theirs, name=ours.name)
    inner = decisions.within(ours.name)
    merged = _ProgramMerge(base, ours, _fresh(base, ours, theirs), inner).whole()
    if merged is None:
        inner = decisions.within(ours.name)
        takes = inner.takes(
            Sentence("how its instructions hang together"),
            Sentence("both changed how its instructions hang together: ours is kept as a whole"),
            Sentence("both changed how its instructions hang together: theirs is taken as a whole"),
        )
        merged = replace(theirs, name=ours.name) if takes else ours
    decisions.found += inner.found
    return merged


def _fresh(base: Program, ours: Program, theirs: Program) -> Program:
    """Theirs, with other ids for its new vertices where ours gave the same ids to new vertices."""
    old = {vertex.id for vertex in base.vertices}
    mine = {vertex.id for vertex in ours.vertices} - old
    taken = mine | old | {vertex.id for vertex in theirs.vertices}
    names: dict[str, str] = {}
    number = 1
    for vertex in theirs.vertices:
        if vertex.id not in mine or vertex.element in (START, STOP):
            continue
        while f"v{number}" in taken:
            number += 1
        names[vertex.id] = f"v{number}"
        taken.add(names[vertex.id])
    vertices = [replace(vertex, id=names.get(vertex.id, vertex.id)) for vertex in theirs.vertices]
    arcs = [
        replace(arc, source=names.get(arc.source, arc.source), target=names.get(arc.target, arc.target))
        for arc in theirs.arcs
    ]
    return replace(theirs, vertices=vertices, arcs=arcs)


class _ProgramMerge:
    def __init__(self, base: Program, ours: Program, theirs: Program, decisions: Decisions) -> None:
        self.sides = (base, ours, theirs)
        self.choose = decisions.choose

    def whole(self) -> Program | None:
        """The merged program; None when it would not hang together."""
        _, ours, theirs = self.sides
        ports = [_ports(program) for program in self.sides]
        if any(found is None for found in ports):
            return None
        vertices = self.vertices()
        if vertices is None:
            return None
        known = {vertex.id for vertex in vertices}
        arcs = self.arcs([found or {} for found in ports], known)
        if arcs is None:
            return None
        robot, level = self.choose(Sentence("the robot"), *((side.target, side.level) for side in self.sides))
        merged = Program(ours.name, robot, vertices, arcs, level)
        return merged if _hangs_together(merged, ours, theirs) else None

    def vertices(self) -> list[Vertex] | None:
        old, mine, other = ({vertex.id: vertex for vertex in side.vertices} for side in self.sides)
        found: dict[str, Vertex] = {}
        for id in merged_order(old, mine, other):
            one, two, three = old.get(id), mine.get(id), other.get(id)
            if two is not None and three is not None:
                found[id] = self.vertex(one or Vertex(id, two.element), two, three)
            elif one is None:
                found[id] = two or three  # type: ignore[assignment]
            elif (two or three) != one:
                return None  # removed by one, changed by the other
        return list(found.values())

    def vertex(self, one: Vertex, two: Vertex, three: Vertex) -> Vertex:
        what = named(two)
        settings: dict[str, str] = {}
        for name in merged_order(one.settings, two.settings, three.settings):
            values = (one.settings.get(name), two.settings.get(name), three.settings.get(name))
            value = self.choose(Sentence("the {setting} of {vertex}", Word(name), what), *values)
            if value is not None:
                settings[name] = value
        return Vertex(
            two.id,
            self.choose(Sentence("the element of {vertex}", what), one.element, two.element, three.element),
            settings,
            self.choose(Sentence("the notes of {vertex}", what), one.notes, two.notes, three.notes),
            self.choose(Sentence("what is inside {vertex}", what), one.unknown, two.unknown, three.unknown),
        )

    def arcs(self, ports: Sequence[Mapping[Port, Arc]], known: set[str]) -> list[Arc] | None:
        old, mine, other = ports
        found: list[Arc] = []
        for port in merged_order(old, mine, other):
            one, two, three = old.get(port), mine.get(port), other.get(port)
            if two != one and three not in (one, two):
                return None  # both put something else here
            arc = three if two == one else two
            if arc is not None:
                if arc.source not in known or arc.target not in known:
                    return None
                found.append(arc)
        return found


def _ports(program: Program) -> dict[Port, Arc] | None:
    """Each out-port's arc; None when two leave one."""
    found = {(arc.source, arc.out): arc for arc in program.arcs}
    return found if len(found) == len(program.arcs) else None


def _hangs_together(merged: Program, ours: Program, theirs: Program) -> bool:
    """Whether nothing came loose, every in-port is entered once, and no chain ends where both sides' went on."""
    into = [(arc.target, arc.at) for arc in merged.arcs if arc.at != RETURN]
    stops = _ids(merged, STOP)
    single = [(target, at) for target, at in into if at != IN or target not in stops]
    if len(single) != len(set(single)):
        return False
    now, mine, other = Outline(merged), Outline(ours), Outline(theirs)
    for vertex in now.spots:
        if now.is_parked(vertex) and not any(vertex in side.spots and side.is_parked(vertex) for side in (mine, other)):
            return False
    return _loose(merged) - stops <= _loose(ours) | _loose(theirs)


def _loose(program: Program) -> set[str]:
    """The vertices that no arc leaves."""
    return _ids(program) - {arc.source for arc in program.arcs}


def _ids(program: Program, element: str | None = None) -> set[str]:
    return {vertex.id for vertex in program.vertices if element in (None, vertex.element)}
