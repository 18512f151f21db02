"""Wheels: drive the robot forward and back, along its road or freely; they also say how large the robot is."""

from __future__ import annotations

from kitrobot.primitives.robot import RobotObject
from kitrobot.sim.devices.base import LATENCY, LOST_COMMANDS, Actuator, Command, Discrete, DisplayKind, Setting, Values
from kitrobot.sim.tables.columns import (
    A_NOISE,
    A_OWN,
    A_ROBOT,
    ACCELERATION,
    BRAKING,
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

FULL_SPEED = A_OWN[0]
"""Column of a drive: full speed in mm/s."""

_STOP, _ADVANCE, _REVERSE = range(3)


class Drive(Actuator):
    """`Advance(speed)`, `Reverse(speed)` in percent of full speed, `Stop()`."""

    name = "drive"
    discrete = Discrete.MOTION
    procedures = ("Stop", "Advance", "Reverse")
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
    def is_driving(cls, k: int, state: State) -> bool:
        return bool(state.robots.floats[TARGET][state.actuators.ints[A_ROBOT][k]])

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
    speed = 0.0
    if procedure != _STOP:
        factor = max(1.0 + deviate * actuator_floats[A_NOISE][k], 0.0)
        speed = command.first / 100 * actuator_floats[FULL_SPEED][k] * factor
    robot = state.actuators.ints[A_ROBOT][k]
    state.robots.floats[TARGET][robot] = -speed if procedure == _REVERSE else speed


def is_busy(k: int, state: State) -> bool:
    """Whether its robot rolls, or is to."""
    robot = state.actuators.ints[A_ROBOT][k]
    floats = state.robots.floats
    return floats[SPEED][robot] != 0.0 or floats[TARGET][robot] != 0.0
