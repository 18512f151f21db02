"""A motor that turns the robot on the spot, counter-clockwise."""

from __future__ import annotations

import math

from kitrobot.primitives.robot import RobotObject
from kitrobot.sim.devices.base import LATENCY, LOST_COMMANDS, Actuator, Command, Discrete, Setting, Values
from kitrobot.sim.tables.columns import A_DONE, A_NOISE, A_OWN, A_ROBOT, DOWN, FAILED, TURN
from kitrobot.sim.tables.state import State
from kitrobot.text.sentences import Sentence

FULL_RATE, RATE, ANGLE_LEFT = A_OWN[:3]
"""Columns of a turning motor, in rad/s and rad: the full rate, the rate now (negative: clockwise), the angle that is
left."""

_STOP, _TURN, _ABSOLUTE, _LEFT_BY, _RIGHT_BY = range(5)
_PART = 0.5
"""The part of the full rate at which degrees are turned."""


class Turn(Actuator):
    """`AbsoluteTurn(angle, speed)` turns by a part of a full turn, `Turn(speed)` goes on until `Stop()`; in percent.

    `LeftBy(angle)` and `RightBy(angle)` turn by degrees.
    """

    name = "turn"
    discrete = Discrete.MOTION
    procedures = ("Stop", "Turn", "AbsoluteTurn", "LeftBy", "RightBy")
    drives = True
    turns = True
    settings = (
        LATENCY,
        LOST_COMMANDS,
        Setting("rate", 180.0, Sentence("full turning speed"), "°/s", 1.0, 36_000.0),
        Setting(
            "noise", 0.0, Sentence("how far an angle or a speed may be off (one standard deviation)"), "%", 0.0, 50.0
        ),
    )

    @classmethod
    def commanded_motion(cls, k: int, state: State) -> tuple[float, float]:
        return 0.0, state.actuators.floats[RATE][k]

    @classmethod
    def initial_floats(cls, part: RobotObject, values: Values) -> tuple[float, ...]:
        return (math.radians(values.number("rate")),)


def start(k: int, command: Command, deviate: float, state: State) -> None:
    """Begins to do what a command says."""
    procedure = command.procedure
    actuator = state.actuators.ints
    actuator_floats = state.actuators.floats
    factor = max(1.0 + deviate * actuator_floats[A_NOISE][k], 0.0)
    if procedure in (_LEFT_BY, _RIGHT_BY):
        angle = command.first * math.pi / 180.0 * factor
        if procedure == _RIGHT_BY:
            angle = -angle
        rate = _PART * actuator_floats[FULL_RATE][k]
        actuator_floats[RATE][k] = -rate if angle < 0.0 else rate
        actuator_floats[ANGLE_LEFT][k] = abs(angle)
        actuator[A_DONE][k] = 0
        return
    rate = 0.0
    if command.arguments > 0 and procedure != _STOP:
        rate = command.last / 100 * actuator_floats[FULL_RATE][k]
    if procedure == _ABSOLUTE:
        actuator_floats[ANGLE_LEFT][k] = command.first / 100 * (2.0 * math.pi) * factor
        actuator[A_DONE][k] = 0
    else:
        rate *= factor
        actuator_floats[ANGLE_LEFT][k] = math.inf
        actuator[A_DONE][k] = 1
    actuator_floats[RATE][k] = rate


def advance(first: int, last: int, dt: float, state: State) -> None:
    """Goes on for a step with the devices `first` … `last` - 1."""
    actuator = state.actuators.ints
    actuator_floats = state.actuators.floats
    turn = state.robots.floats[TURN]
    down = state.robots.ints[DOWN]
    robots = actuator[A_ROBOT]
    done = actuator[A_DONE]
    rates = actuator_floats[RATE]
    lefts = actuator_floats[ANGLE_LEFT]
    for k in range(first, last):
        rate = rates[k]
        if (done[k] and rate == 0.0) or down[robots[k]] == FAILED:
            turn[robots[k]] = 0.0
            continue
        step = abs(rate) * dt
        left = lefts[k]
        if left < step:
            step = left
        turn[robots[k]] = -step if rate < 0.0 else step
        if left < math.inf:
            left -= step
            lefts[k] = left
            if left <= 1e-12:
                rates[k] = 0.0
                done[k] = 1


def is_busy(k: int, state: State) -> bool:
    """Whether it turns. A turn at speed 0 is never done, and nothing comes of it."""
    return state.actuators.floats[RATE][k] != 0.0
