"""A door that takes its time."""

from __future__ import annotations

from kitrobot.primitives.robot import RobotObject
from kitrobot.sim.devices.base import LATENCY, LOST_COMMANDS, Actuator, Command, Setting, Values
from kitrobot.sim.tables.columns import A_DONE, A_NOISE, A_OWN, A_ROBOT, DOWN, FAILED
from kitrobot.sim.tables.state import State
from kitrobot.text.sentences import Sentence

OPENING, TARGET_OPENING, TRAVEL_S, CURRENT_TRAVEL_S = A_OWN
"""Columns of a door: how far it is open (0…1), where it goes, the seconds for all of it, and those for this time."""


class Door(Actuator):
    """`Open()` and `Close()`; its place goes from 0 (closed) to 1 (open)."""

    name = "door"
    procedures = ("Close", "Open")
    settings = (
        LATENCY,
        LOST_COMMANDS,
        Setting("time", 1000.0, Sentence("how long it takes from closed to open"), "ms", 1.0, 3_600_000.0),
        Setting("noise", 0.0, Sentence("how far that time may be off (one standard deviation)"), "%", 0.0, 50.0),
    )

    @classmethod
    def initial_floats(cls, part: RobotObject, values: Values) -> tuple[float, ...]:
        return 0.0, 0.0, values.number("time") / 1000, values.number("time") / 1000


def start(k: int, command: Command, deviate: float, state: State) -> None:
    """Begins to do what a command says."""
    actuator = state.actuators.ints
    actuator_floats = state.actuators.floats
    factor = max(1.0 + deviate * actuator_floats[A_NOISE][k], 0.1)
    actuator_floats[CURRENT_TRAVEL_S][k] = actuator_floats[TRAVEL_S][k] * factor
    actuator_floats[TARGET_OPENING][k] = float(command.procedure)
    actuator[A_DONE][k] = 0


def advance(first: int, last: int, dt: float, state: State) -> None:
    """Goes on for a step with the devices `first` … `last` - 1."""
    actuator = state.actuators.ints
    actuator_floats = state.actuators.floats
    down = state.robots.ints[DOWN]
    done = actuator[A_DONE]
    for k in range(first, last):
        if done[k] or down[actuator[A_ROBOT][k]] == FAILED:
            continue
        way = actuator_floats[TARGET_OPENING][k] - actuator_floats[OPENING][k]
        step = dt / actuator_floats[CURRENT_TRAVEL_S][k]
        if abs(way) <= step + 1e-12:
            actuator_floats[OPENING][k] = actuator_floats[TARGET_OPENING][k]
            done[k] = 1
        elif way > 0.0:
            actuator_floats[OPENING][k] += step
        else:
            actuator_floats[OPENING][k] -= step
