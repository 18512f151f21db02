"""Agents of a run as they are now: their poses, their flags, and everything a reader sees of one."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from kitrobot.sim.step.agents import Agent
from kitrobot.sim.tables import columns
from kitrobot.sim.tables.state import State, numbers
from kitrobot.trace.model import Threads
from kitrobot.world.geometry import normalised

LAMP = columns.SIGN_LAMP
FAILED = 2
ALARM = columns.SIGN_ALARM
ARM = columns.SIGN_ARM
MOVING = 16
STALLED = 32
MUTED = 64
"""The bits of an agent's flags: lamp on, failed, collision sensor pressed, arm out, moving, stalled, without radio."""


_STATES = (columns.SIGNS, columns.DOWN, columns.MUTED)
_MOTION = (columns.SPEED, columns.TURN)


@dataclass(frozen=True, slots=True)
class AgentView:
    """An agent as it is now. `kind` is carrier, loader, unloader, store-manager or robot; `number` counts within a
    kind.

    `state` is "failed" or "stalled" when that befell it; else "running" while a device of it works or moves, "waiting"
    while only its program goes on, "idle" after its program has ended. `active` is (slot, instruction) of each live
    thread. `shown` is what its displays and the like show, by the actuator (docs/trace.md says which numbers).
    """

    name: str
    program: str
    robot: str
    kind: str
    number: int
    x_mm: float
    y_mm: float
    heading_rad: float
    load: int
    flags: int
    state: str
    active: Threads
    values: Mapping[str, int]
    inputs: Mapping[str, int]
    shown: Mapping[str, list[int]]
    fault: int


def flags_of(state: State, index: int) -> int:
    """What devices show on the body of an agent, its motion and its faults, as bits."""
    floats, ints = state.robots.floats, state.robots.ints
    return (
        int(ints[columns.SIGNS][index])
        | (FAILED if ints[columns.DOWN][index] == columns.FAILED else 0)
        | (STALLED if ints[columns.DOWN][index] == columns.STALLED else 0)
        | (MUTED if ints[columns.MUTED][index] else 0)
        | (MOVING if floats[columns.SPEED][index] or floats[columns.TURN][index] else 0)
    )


def all_flags(state: State) -> list[int]:
    """`flags_of` every agent, faster than one after another."""
    downs = [0, STALLED, FAILED]
    rows = zip(*_rows(state.robots.ints, _STATES), *_rows(state.robots.floats, _MOTION), strict=True)
    return [
        signs + downs[down] + MUTED * muted + (MOVING if speed or turn else 0)
        for signs, down, muted, speed, turn in rows
    ]


def commanded(state: State) -> set[int]:
    """The agents of which a device took a new command in the last step."""
    ints, step = state.actuators.ints, state.clock[columns.TICK]
    fresh = numbers(ints[columns.A_FRESH])
    if step not in fresh:
        return set()
    return {robot for robot, at in zip(numbers(ints[columns.A_ROBOT]), fresh, strict=True) if at == step}


def _rows(table: Any, names: tuple[int, ...]) -> list[list[Any]]:
    return [numbers(table[name]) for name in names]


def poses_of(state: State) -> list[tuple[float, float, float, int, int]]:
    """(x mm, y mm, heading rad, load, flags) of each agent, in team order."""
    rows = _rows(state.robots.floats, (columns.X, columns.Y, columns.HEADING))
    loads = numbers(state.robots.ints[columns.LOAD])
    return [
        (x, y, normalised(heading), load, flags)
        for x, y, heading, load, flags in zip(*rows, loads, all_flags(state), strict=True)
    ]


def view_of(agent: Agent) -> AgentView:
    """An agent as it is now."""
    index, machine, robots = agent.index, agent.machine, agent.state.robots
    return AgentView(
        agent.name,
        agent.program,
        agent.robot.name,
        agent.kind,
        agent.number,
        float(robots.floats[columns.X][index]),
        float(robots.floats[columns.Y][index]),
        normalised(robots.floats[columns.HEADING][index]),
        int(robots.ints[columns.LOAD][index]),
        flags_of(agent.state, index),
        agent.doing,
        agent.active,
        machine.variables(),
        {name: machine.input(name) for name in machine.layout.sensors},
        dict(agent.outputs()),
        machine.fault,
    )
