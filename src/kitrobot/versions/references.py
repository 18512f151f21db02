"""Another name for something of a mission, everywhere the mission speaks of it.

Names stand as attributes of their own, as the object of an element (`Trips.Add`), in typed fields that name sets or
programs, and in LLL: the code of own parts, the conditions of breakpoints and properties. Notes and texts for people
stay as they are. Missions that are given are not changed. Left to others: which names changed (renames).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from enum import StrEnum
from typing import Any

from kitrobot.graph.model import Program, Vertex
from kitrobot.lll.name_replacement import renamed_text
from kitrobot.lll.parse_results import parse_team
from kitrobot.lll.tree import Hole, Joint
from kitrobot.lll.walk import nodes
from kitrobot.mission.model import Agent, Mission, Team
from kitrobot.mission.trial import Breakpoint
from kitrobot.primitives.catalogue import load_catalogue
from kitrobot.primitives.constructors import Constructor
from kitrobot.primitives.own_xml import OwnVariable, read_own, write_constructor, write_variable
from kitrobot.world.model import World

Names = Mapping[str, str]
"""Old name → new name."""
NOTHING: Names = {}


class NameKind(StrEnum):
    """What has a name in a mission that other parts of it use, in the order in which renames are looked for."""

    VARIABLE = "variable"
    PART = "own part"
    ROAD = "road"
    STOREHOUSE = "storehouse"
    DOCK = "dock"
    START = "start"
    PROGRAM = "program"
    AGENT = "agent"
    ROLE = "role"
    GROUP = "group"
    WORK = "work"


def with_names(mission: Mission, kind: NameKind, names: Names, robot: str = "") -> Mission:
    """The mission in which what is of a kind goes by new names.

    Args:
        mission: stays as it is.
        kind: what is renamed.
        names: old name → new name; all change at once.
        robot: of variables, the kind of robot that has them.
    """
    names = {old: new for old, new in names.items() if old != new}
    if not names:
        return mission
    match kind:
        case NameKind.VARIABLE:
            return _variables(mission, names, robot)
        case NameKind.PART:
            return _own_parts(mission, names)
        case NameKind.ROAD | NameKind.STOREHOUSE | NameKind.DOCK | NameKind.START:
            return _world(mission, kind, names)
        case NameKind.PROGRAM:
            return _programs(mission, names)
        case NameKind.WORK:
            return _works(mission, names)
        case _:
            return _members(mission, kind, names)


def _renamed(names: Names, things: Iterable[Any], *fields: str) -> list[Any]:
    """Things whose attributes `fields` hold new names."""
    found = []
    for thing in things:
        changed = {field: names[was] for field in fields if (was := getattr(thing, field)) in names}
        found.append(replace(thing, **changed) if changed else thing)
    return found


def _on_vertices(mission: Mission, change: Callable[[Program, Vertex], Vertex]) -> list[Program]:
    return [replace(one, vertices=[change(one, vertex) for vertex in one.vertices]) for one in mission.programs]


def _with_object(vertex: Vertex, names: Names) -> Vertex:
    owner, dot, method = vertex.element.partition(".")
    return replace(vertex, element=f"{names[owner]}.{method}") if dot and owner in names else vertex


def _with_code(
    constructor: Constructor, objects: Names = NOTHING, members: Names = NOTHING, programs: Names = NOTHING
) -> Constructor:
    code = renamed_text(constructor.code, objects=objects, members=members, programs=programs)
    if code == constructor.code:
        return constructor
    made, _ = read_own(write_constructor(replace(constructor, code=code)), constructor.name)
    return made if isinstance(made, Constructor) else constructor


# -- what robots have


def _variables(mission: Mission, names: Names, robot: str) -> Mission:
    owners: dict[str, set[str]] = {}
    for one in mission.variables:
        owners.setdefault(one.variable.name, set()).add(one.robot)
    # What does not say which robot it is for means this one's, where no other has a variable of that name.
    alone = {old: new for old, new in names.items() if owners.get(old, {robot}) == {robot}}
    targets = {program.name: program.target for program in mission.programs}

    def of(program: str) -> Names:
        target = targets.get(program)
        return names if target == robot else alone if target == "" else {}

    return replace(
        mission,
        variables=[_with_variable(one, names) if one.robot == robot else one for one in mission.variables],
        programs=_on_vertices(mission, lambda program, vertex: _with_object(vertex, of(program.name))),
        breakpoints=_conditions_of_breakpoints(mission, of),
        properties=[_property_objects(mission, one, names, robot) for one in mission.properties],
        constructors=[_with_code(one, objects=alone) for one in mission.constructors],
    )


def _with_variable(own: OwnVariable, names: Names) -> OwnVariable:
    name = names.get(own.variable.name)
    if name is None:
        return own
    renamed = replace(own, variable=replace(own.variable, name=name))
    # Its methods say what it is called.
    made, _ = read_own(write_variable(renamed), name)
    return made if isinstance(made, OwnVariable) else renamed


def _conditions_of_breakpoints(mission: Mission, objects_of: Callable[[str], Names]) -> list[Breakpoint]:
    return [
        replace(one, when=renamed_text(one.when, objects=objects_of(one.program))) if one.when else one
        for one in mission.breakpoints
    ]


def _property_objects(mission: Mission, asked: Any, names: Names, robot: str) -> Any:
    def changed(text: str) -> str:
        parsed = parse_team(f"[{text}](WAIT(1));", "condition")
        joints = [one for one in nodes(parsed.program.seq) if isinstance(one, Joint)]
        for one in sorted(joints, key=lambda one: -one.start):
            members = one.members.names if not isinstance(one.members, Hole) else [one.members.name]
            if any(robot in _kinds(mission, name) for name in members):
                test = renamed_text(text[one.start - 1 : one.end - 1], objects=names)
                text = text[: one.start - 1] + test + text[one.end - 1 :]
        return text

    return replace(asked, first=changed(asked.first), second=changed(asked.second) if asked.second else "")


def _kinds(mission: Mission, name: str, seen: frozenset[str] = frozenset()) -> set[str]:
    """The kinds of robot that a name in a condition stands for."""
    targets = {program.name: program.target for program in mission.programs}
    team = mission.team
    found = {one.robot for one in team.roles if one.name == name}
    for group in team.groups:
        if group.name == name and name not in seen:
            found.update(*(_kinds(mission, one, seen | {name}) for one in group.members.names))
    agents = [one for one in team.agents if name in (one.name, one.program)]
    return found | {one.robot or targets.get(one.program, "") for one in agents}


def _own_parts(mission: Mission, names: Names) -> Mission:
    def adding(one: Constructor) -> Constructor:
        if one.adds is not None and one.adds[0] in names:
            return replace(one, adds=(names[one.adds[0]], one.adds[1]))
        return one

    return replace(
        mission,
        constructors=[adding(one) for one in _renamed(names, mission.constructors, "name")],
        programs=_on_vertices(mission, lambda _, vertex: _renamed(names, [vertex], "element")[0]),
    )


# -- places


def _world(mission: Mission, kind: NameKind, names: Names) -> Mission:
    world, team = mission.own_world, mission.team
    if world is None:
        return mission
    if kind is NameKind.START:
        agents = [_at_start(one, names.get(one.start_name, one.start_name)) for one in team.agents]
        world = replace(world, starts=tuple(_renamed(names, world.starts, "name")))
        return replace(mission, own_world=world, team=replace(team, agents=agents))
    lists = {NameKind.ROAD: "roads", NameKind.DOCK: "docks", NameKind.STOREHOUSE: "storehouses"}
    own = {lists[kind]: tuple(_renamed(names, getattr(world, lists[kind]), "name"))}
    after: World = replace(world, **own)  # type: ignore[arg-type]
    after = replace(after, starts=tuple(_renamed(names, after.starts, kind.value)))
    if kind is not NameKind.DOCK:
        after = replace(after, docks=tuple(_renamed(names, after.docks, kind.value)))
    if kind is NameKind.STOREHOUSE:
        team = replace(team, goals=_renamed(names, team.goals, "storehouse"))
    return replace(mission, own_world=after, team=team)


def _at_start(agent: Agent, start: str) -> Agent:
    return replace(agent, start="" if start == agent.name else start) if start != agent.start_name else agent


# -- the team


def _programs(mission: Mission, names: Names) -> Mission:
    others = {*(one.name for one in mission.team.agents), *_declared(mission.team)}
    members = {old: new for old, new in names.items() if old not in others}
    return replace(
        mission,
        programs=_renamed(names, _typed_names(mission, "program", names), "name"),
        team=replace(mission.team, agents=_renamed(names, mission.team.agents, "program")),
        breakpoints=_renamed(names, mission.breakpoints, "program"),
        properties=_property_members(mission, members),
        constructors=[_with_code(one, programs=names) for one in mission.constructors],
    )


def _works(mission: Mission, names: Names) -> Mission:
    teams = {program.name for program in mission.programs if program.level.is_team}

    def of(program: str) -> Names:
        return names if program in teams else {}

    asked = mission.properties
    return replace(
        mission,
        team=replace(mission.team, works=_renamed(names, mission.team.works, "name")),
        programs=_on_vertices(mission, lambda program, vertex: _with_object(vertex, of(program.name))),
        breakpoints=_conditions_of_breakpoints(mission, of),
        properties=[_on_conditions(one, lambda text: renamed_text(text, objects=names)) for one in asked],
        constructors=[_with_code(one, objects=names) for one in mission.constructors],
    )


def _members(mission: Mission, kind: NameKind, names: Names) -> Mission:
    """Roles, groups and agents, which sets name; a role or a group of a name is meant before an agent."""
    team = mission.team
    if kind is NameKind.AGENT:
        members = {old: new for old, new in names.items() if old not in _declared(team)}
        agents = [_at_start(replace(one, name=names.get(one.name, one.name)), one.start_name) for one in team.agents]
        changed: Team = replace(team, agents=agents)
        breakpoints = [
            replace(one, agents=tuple(names.get(name, name) for name in one.agents)) for one in mission.breakpoints
        ]
        failures = _renamed(names, mission.failures, "agent")
    else:
        members = dict(names)
        rows = "roles" if kind is NameKind.ROLE else "groups"
        changed = replace(team, **{rows: _renamed(names, getattr(team, rows), "name")})
        breakpoints, failures = mission.breakpoints, mission.failures
    groups = [
        replace(one, members=replace(one.members, names=[members.get(name, name) for name in one.members.names]))
        for one in changed.groups
    ]
    return replace(
        mission,
        team=replace(changed, groups=groups),
        programs=_typed_names(mission, "set", members),
        breakpoints=breakpoints,
        failures=failures,
        properties=_property_members(mission, members),
        constructors=[_with_code(one, members=members) for one in mission.constructors],
    )


def _declared(team: Team) -> set[str]:
    return {one.name for row in (team.roles, team.groups) for one in row}


def _property_members(mission: Mission, members: Names) -> list[Any]:
    return [
        _on_conditions(one, lambda text: renamed_text(text, members=members, sets=True)) for one in mission.properties
    ]


def _on_conditions(asked: Any, change: Callable[[str], str]) -> Any:
    return replace(asked, first=change(asked.first), second=change(asked.second) if asked.second else "")


def _typed_names(mission: Mission, what: str, names: Names) -> list[Program]:
    """The programs with other names in their fields that name sets, or programs."""
    if not any(program.level.is_team for program in mission.programs):
        return mission.programs
    known = {**load_catalogue().constructors, **{one.name: one for one in mission.constructors}}

    def change(program: Program, vertex: Vertex) -> Vertex:
        constructor = known.get(vertex.element)
        if constructor is None or not program.level.is_team:
            return vertex
        fields = [slot.name for slot in constructor.slots if slot.names == what and slot.name in vertex.settings]
        texts = {name: renamed_text(vertex.settings[name], members=names, sets=True) for name in fields}
        return replace(vertex, settings={**vertex.settings, **texts})

    return _on_vertices(mission, change)
