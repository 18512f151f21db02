"""The first program of a whole team, from a mission whose agents each run a program of their own.

What the agents do stays what it is: each program that agents run becomes a role, and the team's program lets those of
a role do it, each on its own. From there on lines can be put together, and roles be shared out anew.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

from kitrobot.compiler.text.lll_to_graph import lll_to_graph
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.graph.model import Program
from kitrobot.lll.tree import Instr, Members, Parallel, ParOfSeq, ProgramCall, RoleDeclaration, Seq
from kitrobot.mission.model import Mission
from kitrobot.primitives.levels import Level
from kitrobot.text.sentences import Sentence
from kitrobot.workspace.mission_loader import OpenMission


class TeamThereError(KitRobotError):
    """The mission has a program of the whole team already."""


def first_team(opened: OpenMission, name: str) -> Mission:
    """The mission with a program of the whole team, which its agents run from now on.

    Args:
        opened: a mission without such a program; it is not changed.
        name: what the program is called; a number is put behind a name that is taken.

    Agents whose program is not there, or is for a robot that is not at hand, stay as they are.

    Raises:
        TeamThereError: there is such a program.
        KitRobotError: a constructor that it is drawn with is not at hand.
    """
    before = opened.mission
    if any(program.level is Level.SOCIAL for program in before.programs):
        raise TeamThereError(
            Sentence("the mission has a program of the whole team already"),
            Sentence("let the robots run that one, or remove it first"),
        )
    robots = opened.catalogue.robots
    kinds = {one.name: one.target for one in before.programs if one.target in robots}
    team = before.team
    played = [one for one in kinds if any(agent.program == one for agent in team.agents)]
    taken = {role.name for role in team.roles} | {group.name for group in team.groups}
    taken |= {work.name for work in team.works}
    roles: dict[str, RoleDeclaration] = {}
    for program in played:
        count = sum(agent.program == program for agent in team.agents)
        role = free_name(program, taken)
        taken.add(role)
        roles[program] = RoleDeclaration(role, kinds[program], count, count)
    name = free_name(name, {one.name for one in before.programs})
    # Each role takes the first free robots of its kind.
    order = {program: number for number, program in enumerate(played)}
    agents = [
        replace(agent, program=name, robot=kinds[agent.program]) if agent.program in roles else agent
        for agent in sorted(team.agents, key=lambda agent: order.get(agent.program, len(order)))
    ]
    if len({role.robot for role in roles.values()}) == len(roles):
        places = {agent.name: number for number, agent in enumerate(team.agents)}
        agents.sort(key=lambda agent: places[agent.name])
    made = replace(team, agents=agents, roles=[*team.roles, *roles.values()])
    with_roles = replace(before, team=made, programs=[*before.programs, Program(name, "", [], [], Level.SOCIAL)])
    parts = opened.catalogue.extended([], [], with_roles.crew)
    drawn = lll_to_graph(_each_its_own(roles), parts.teams[Level.SOCIAL], parts, name)
    return replace(with_roles, programs=[*before.programs, drawn])


def free_name(name: str, taken: Collection[str]) -> str:
    """The name, or the first of `name-2`, `name-3`, … that is not taken."""
    number, free = 1, name
    while free in taken:
        number += 1
        free = f"{name}-{number}"
    return free


def _each_its_own(roles: dict[str, RoleDeclaration]) -> Seq:
    """Those of each role do its program, each on its own, all roles at the same time."""
    blocks: list[Instr] = [
        ParOfSeq(Members([role.name], braced=False), Seq([ProgramCall(program)])) for program, role in roles.items()
    ]
    return Seq(blocks if len(blocks) < 2 else [Parallel([Seq([block]) for block in blocks])])
