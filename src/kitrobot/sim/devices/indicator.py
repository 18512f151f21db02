"""An actuator of one's own that changes nothing in the world: it takes its time, and its value is shown."""

from __future__ import annotations

import math

from kitrobot.primitives.robot import Method, RobotObject
from kitrobot.sim.devices.base import LATENCY, LOST_COMMANDS, Actuator, Command, DisplayKind, Setting, Values
from kitrobot.sim.tables.columns import A_ACTION, A_DONE, A_NOISE, A_OWN, A_ROBOT, DOWN, FAILED
from kitrobot.sim.tables.state import State
from kitrobot.text.sentences import Sentence

VALUE, TARGET_VALUE, DURATION_S, REMAINING_S = A_OWN
"""Columns of an indicator: its value, the value it goes to, how long that takes, and how much of this is left, in s."""

_LAMP, _BAR, _SOUND, _NUMBER = range(4)
_SHOWS: tuple[DisplayKind, ...] = ("lamp", "bar", "sound", "number")
_LATER = 4
_WORTH = 8


class Indicator(Actuator):
    """Procedures of any name. One with a parameter gives it that value; the `stop` of another gives 0, any other the
    largest value. A bar goes there evenly in `time`. A lamp or a sound whose procedure `completes` later is on for
    `time`.
    """

    name = "indicator"
    outputs = 1
    shown = 1
    settings = (
        LATENCY,
        LOST_COMMANDS,
        Setting("shows", "lamp", Sentence("how its value is shown"), words=_SHOWS),
        Setting("time", 0.0, Sentence("how long it takes"), "ms", 0.0, 3_600_000.0),
        Setting("noise", 0.0, Sentence("how far that time may be off (one standard deviation)"), "%", 0.0, 50.0),
    )

    @classmethod
    def display_kind(cls, values: Values) -> DisplayKind:
        return _SHOWS[_SHOWS.index(values.word("shows"))]

    @classmethod
    def initial_floats(cls, part: RobotObject, values: Values) -> tuple[float, ...]:
        return 0.0, 0.0, values.number("time") / 1000

    @classmethod
    def procedure_number(cls, part: RobotObject, method: Method, values: Values) -> int:
        """What it shows, whether it completes later, and the value of a procedure without parameters, in one number."""
        ends = any(other.stop == method.name for other in part.methods)
        most = max((other.parameters[0].maximum for other in part.methods if other.parameters), default=1)
        worth = 0 if ends else max(most, 1)
        return _SHOWS.index(values.word("shows")) + (_LATER if method.completes_later else 0) + _WORTH * worth


def start(k: int, command: Command, deviate: float, state: State) -> None:
    """Begins to do what a command says."""
    actuator = state.actuators.ints
    floats = state.actuators.floats
    output = state.actuators.outputs[k]
    code = command.procedure
    value = command.first if command.arguments > 0 else code // _WORTH
    shows = code % _LATER
    later = code % _WORTH >= _LATER
    factor = max(1.0 + deviate * floats[A_NOISE][k], 0.1)
    left = floats[DURATION_S][k] * factor
    floats[TARGET_VALUE][k] = float(value)
    floats[REMAINING_S][k] = left
    actuator[A_ACTION][k] = code % _WORTH
    if left > 0.0 and (later or shows == _BAR):
        actuator[A_DONE][k] = 0
        if shows != _BAR:
            output[0] = value
    else:
        actuator[A_DONE][k] = 1
        floats[VALUE][k] = float(value)
        output[0] = value


def advance(first: int, last: int, dt: float, state: State) -> None:
    """Goes on for a step with the devices `first` … `last` - 1; a robot that failed makes no sound."""
    actuator = state.actuators.ints
    outputs = state.actuators.outputs
    down = state.robots.ints[DOWN]
    places = state.actuators.floats[VALUE]
    targets = state.actuators.floats[TARGET_VALUE]
    lefts = state.actuators.floats[REMAINING_S]
    for k in range(first, last):
        shows = actuator[A_ACTION][k] % _LATER
        if down[actuator[A_ROBOT][k]] == FAILED:
            if shows == _SOUND:
                outputs[k][0] = 0
            continue
        if actuator[A_DONE][k]:
            continue
        left = lefts[k] - dt
        lefts[k] = left
        if left > 1e-9:
            if shows == _BAR:
                places[k] += (targets[k] - places[k]) * dt / (left + dt)
                outputs[k][0] = math.floor(places[k] + 0.5)
            continue
        actuator[A_DONE][k] = 1
        lefts[k] = 0.0
        places[k] = targets[k]
        outputs[k][0] = 0 if shows in (_LAMP, _SOUND) else int(targets[k])
