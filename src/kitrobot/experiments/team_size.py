"""Another number of agents of one program, or one kind: fewer leave from the end of the team, more join at starts.

Whoever joins takes the first start that is free and of the kind of the last agent's; where none is, one is added: on
its road as far as possible from everybody there, beside a free pose in a row, or at the same dock or storehouse.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

from kitrobot.experiments.variant import Variant
from kitrobot.mission.model import Agent
from kitrobot.workspace.first_team import free_name
from kitrobot.world.model import Start, World

MOST_OF_A_PROGRAM = 10_000
ROW_MM = 150.0
"""How far from each other those stand that join in the open."""


def set_team_size(variant: Variant, program: str, robot: str, count: int) -> None:
    """Lets so many agents run a program, those of a kind of robot where it is a team's; somebody does now."""
    team = variant.mission.team
    mine = [agent for agent in team.agents if (agent.program, agent.robot) == (program, robot)]
    gone = {agent.name for agent in mine[count:]}
    if gone:
        team.agents = [agent for agent in team.agents if agent.name not in gone]
        variant.mission.failures = [one for one in variant.mission.failures if one.agent not in gone]
        return
    last = mine[-1]
    for _ in range(count - len(mine)):
        taken = {agent.name for agent in team.agents}
        start = _start(variant, last)
        name = start.name if start.name not in taken else _next_name(last.name, taken)
        joined = Agent(name, program, "" if start.name == name else start.name, last.robot)
        at = max(n for n, agent in enumerate(team.agents) if (agent.program, agent.robot) == (program, robot))
        team.agents.insert(at + 1, joined)


def _start(variant: Variant, like: Agent) -> Start:
    """A start for one more, in the world from now on."""
    world = variant.world
    model = world.start(like.start_name)
    assert model is not None, "the mission has no errors"
    for name in variant.mission.team.free(start.name for start in world.starts):
        free = world.start(name)
        if free is not None and _kind(free) == _kind(model):
            return free
    name = _next_name(model.name, {start.name for start in world.starts})
    made = _beside(variant, model, name)
    variant.world = replace(world, starts=(*world.starts, made))
    return made


def _next_name(name: str, taken: Collection[str]) -> str:
    """`carrier-4` behind `carrier-3`, or the first after it that is free."""
    stem, _, number = name.rpartition("-")
    if not stem or not number.isdecimal():
        return free_name(name, taken)
    count = int(number) + 1
    while f"{stem}-{count}" in taken:
        count += 1
    return f"{stem}-{count}"


def _kind(start: Start) -> tuple[str, str, str]:
    return start.road, start.dock, start.storehouse


def _beside(variant: Variant, model: Start, name: str) -> Start:
    world = variant.world
    if model.road:
        return replace(model, name=name, at_mm=_widest_gap(variant, world, model.road))
    if model.pose is None:
        return replace(model, name=name)
    taken = {(start.pose.x_mm, start.pose.y_mm) for start in world.starts if start.pose is not None}
    x_mm, y_mm = model.pose.x_mm, model.pose.y_mm
    row, away = y_mm, 0
    while (x_mm, y_mm) in taken:
        away += 1
        x_mm = model.pose.x_mm + away * ROW_MM
        if x_mm > world.width_mm - ROW_MM / 2:
            row, away = row + ROW_MM, 0
            x_mm = model.pose.x_mm
        y_mm = row
    return replace(model, name=name, pose=replace(model.pose, x_mm=x_mm, y_mm=y_mm))


def _widest_gap(variant: Variant, world: World, road: str) -> float:
    """The middle of the longest stretch of a road without an agent's start."""
    line = world.roads[next(at for at, one in enumerate(world.roads) if one.name == road)]
    used = {agent.start_name for agent in variant.mission.team.agents}
    places = sorted(start.at_mm for start in world.starts if start.road == road and start.name in used)
    if not places:
        return 0.0
    length = line.length_mm
    ends = [*places[1:], places[0] + length if line.closed else length]
    gap, begin = max((end - place, -place) for place, end in zip(places, ends, strict=True))
    middle = -begin + gap / (2 if line.closed else 1.5)
    return round(middle % length, 3)
