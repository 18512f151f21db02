"""Wheels: drive the robot forward and back, along its road or freely; they also say how large the robot is."""

from __future__ import annotations

import math

from kitrobot.primitives.robot import RobotObject
from kitrobot.sim.devices.base import LATENCY, LOST_COMMANDS, Actuator, Command, Discrete, DisplayKind, Setting, Values
from kitrobot.sim.tables.columns import (
    A_DONE,
    A_NOISE,
    A_OWN,
    A_ROBOT,
    ACCELERATION,
    BRAKING,
    DOWN,
    FAILED,
    FREE,
    LENGTH,
    RADIUS,
    ROAD,
    SOLID,
    SPEED,
    TARGET,
)
from kitrobot.sim.tables.state import State
from kitrobot.text.sentences import Sentence

FULL_SPEED, DISTANCE_LEFT, CRUISE, ROLLED = A_OWN
"""Columns of a drive, in mm/s and mm: full speed; of a distance that it drives, how much is left, the speed that it
takes, negative for backward, and the speed along it now."""

_STOP, _ADVANCE, _REVERSE, _DRIVE_BY, _BACK_BY = range(5)
_CRUISE = 0.5
"""The part of full speed at which a distance is driven."""

_NOTHING_MM = 1e-9
"""What is left of a distance that is done."""


class Drive(Actuator):
    """`Advance(speed)`, `Reverse(speed)` in percent of full speed, `Stop()`; `DriveBy(distance)` and
    `BackBy(distance)` in centimetres end by themselves, where the wheels have rolled that far.
    """

    name = "drive"
    discrete = Discrete.MOTION
    procedures = ("Stop", "Advance", "Reverse", "DriveBy", "BackBy")
    drives = True
    settings = (
        LATENCY,
        LOST_COMMANDS,
        Setting("speed", 400.0, Sentence("full speed"), "mm/s", 1.0, 100_000.0),
        Setting("acceleration", 800.0, Sentence("how fast it gains speed"), "mm/s²", 1.0),
        Setting("braking", 800.0, Sentence("how fast it loses speed"), "mm/s²", 1.0),
        Setting("length", 135.0, Sentence("the robot's length"), "mm", 1.0, 10_000.0),
        Setting("width", 95.0, Sentence("the robot's width"), "mm", 1.0, 10_000.0),
        Setting("guide", "free", Sentence("what leads it"), words=("free", "road")),
        Setting("noise", 0.0, Sentence("how far a speed may be off (one standard deviation)"), "%", 0.0, 50.0),
    )

    @classmethod
    def commanded_motion(cls, k: int, state: State) -> tuple[float, float]:
        return state.robots.floats[TARGET][state.actuators.ints[A_ROBOT][k]], 0.0

    @classmethod
    def display_kind(cls, values: Values) -> DisplayKind:
        return "wheels"

    @classmethod
    def initial_floats(cls, part: RobotObject, values: Values) -> tuple[float, ...]:
        return (values.number("speed"),)

    @classmethod
    def fit(cls, robot: int, floats: list[list[float]], ints: list[list[int]], values: Values) -> None:
        floats[ACCELERATION][robot] = values.number("acceleration")
        floats[BRAKING][robot] = values.number("braking")
        floats[LENGTH][robot] = values.number("length")
        floats[RADIUS][robot] = values.number("length") / 2
        ints[SOLID][robot] = 1
        if values.word("guide") == "road":
            # Robots on different roads keep only their widths apart, else a bend would count as a crash.
            floats[RADIUS][robot] = values.number("width") / 2
        else:
            ints[ROAD][robot] = FREE


def start(k: int, command: Command, deviate: float, state: State) -> None:
    """Begins to do what a command says; `deviate` is a normal deviate."""
    procedure = command.procedure
    actuator_floats = state.actuators.floats
    floats = state.robots.floats
    robot = state.actuators.ints[A_ROBOT][k]
    factor = max(1.0 + deviate * actuator_floats[A_NOISE][k], 0.0)
    state.actuators.ints[A_DONE][k] = 1
    if procedure in (_DRIVE_BY, _BACK_BY):
        distance = command.first * 10.0 * factor
        if procedure == _BACK_BY:
            distance = -distance
        cruise = _CRUISE * actuator_floats[FULL_SPEED][k]
        actuator_floats[CRUISE][k] = -cruise if distance < 0.0 else cruise
        actuator_floats[DISTANCE_LEFT][k] = abs(distance)
        actuator_floats[ROLLED][k] = -floats[SPEED][robot] if distance < 0.0 else floats[SPEED][robot]
        state.actuators.ints[A_DONE][k] = 0
        return
    speed = 0.0
    if procedure != _STOP:
        speed = command.first / 100 * actuator_floats[FULL_SPEED][k] * factor
    floats[TARGET][robot] = -speed if procedure == _REVERSE else speed


def advance(first: int, last: int, dt: float, state: State) -> None:
    """Goes on for a step with the devices `first` … `last` - 1 that drive a distance.

    The robot is told the mean speed of the step, which it has at once. It brakes so that it stands where the distance
    ends, exactly and whatever the step. What counts is how far its wheels roll, so a distance ends at a wall too.
    """
    actuator = state.actuators.ints
    done = actuator[A_DONE]
    floats = state.robots.floats
    down = state.robots.ints[DOWN]
    for k in range(first, last):
        if done[k]:
            continue
        i = actuator[A_ROBOT][k]
        v = state.actuators.floats[ROLLED][k]
        left = state.actuators.floats[DISTANCE_LEFT][k]
        cruise = state.actuators.floats[CRUISE][k]
        if down[i] == FAILED:
            state.actuators.floats[ROLLED][k] = -floats[SPEED][i] if cruise < 0.0 else floats[SPEED][i]
            continue
        if left <= 0.0:
            floats[SPEED][i] = -v if cruise < 0.0 else v
            floats[TARGET][i] = 0.0
            done[k] = 1
            continue
        after = _next_speed(v, left, abs(cruise), dt, floats[ACCELERATION][i], floats[BRAKING][i])
        way = (v + after) / 2.0 * dt
        if way >= left or left - way < _NOTHING_MM:
            way = left
        state.actuators.floats[DISTANCE_LEFT][k] = left - way
        state.actuators.floats[ROLLED][k] = after
        mean = way / dt
        if cruise < 0.0:
            mean = -mean
        floats[SPEED][i] = mean
        floats[TARGET][i] = mean


def _next_speed(v: float, left: float, cruise: float, dt: float, acceleration: float, braking: float) -> float:
    """The speed at the end of a step, mm/s, from which the robot can still brake within what is left."""
    if v < 0.0:  # it rolls the other way, and brakes
        return min(0.0, v + braking * dt)
    rest = left - v * dt / 2.0
    after = 0.0
    if rest > 0.0:
        after = braking * (math.sqrt(dt * dt / 4.0 + 2.0 * rest / braking) - dt / 2.0)
    return max(max(v - braking * dt, 0.0), min(after, min(cruise, v + acceleration * dt)))


def is_busy(k: int, state: State) -> bool:
    """Whether its robot rolls, or is to."""
    robot = state.actuators.ints[A_ROBOT][k]
    floats = state.robots.floats
    return floats[SPEED][robot] != 0.0 or floats[TARGET][robot] != 0.0
