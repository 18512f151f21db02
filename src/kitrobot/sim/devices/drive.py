"""Wheels: drive the robot forward and back, along its road or freely; they also say how large the robot is."""

from __future__ import annotations

from kitrobot.primitives import RobotObject
from kitrobot.sim.columns import (
    A_NOISE,
    A_P,
    A_ROBOT,
    ACCELERATION,
    BRAKING,
    FREE,
    LENGTH,
    RADIUS,
    ROAD,
    SOLID,
)
from kitrobot.sim.devices.base import LATENCY, LOST_COMMANDS, Actuator, Setting, Values

DRIVE = 3
_STOP, _ADVANCE, _REVERSE = range(3)


class Drive(Actuator):
    """`Advance(speed)`, `Reverse(speed)` in percent of full speed, `Stop()`."""

    name = "drive"
    kind = DRIVE
    procedures = ("Stop", "Advance", "Reverse")
    settings = (
        LATENCY,
        LOST_COMMANDS,
        Setting("speed", 400.0, "full speed", "mm/s", 1.0, 100_000.0),
        Setting("acceleration", 800.0, "how fast it gains speed", "mm/s²", 1.0),
        Setting("braking", 800.0, "how fast it loses speed", "mm/s²", 1.0),
        Setting("length", 135.0, "the robot's length", "mm", 1.0, 10_000.0),
        Setting("width", 95.0, "the robot's width", "mm", 1.0, 10_000.0),
        Setting("guide", "free", "what leads it", words=("free", "road")),
        Setting("noise", 0.0, "how far a speed may be off (one standard deviation)", "%", 0.0, 50.0),
    )

    @classmethod
    def reals(cls, part: RobotObject, values: Values) -> tuple[float, ...]:
        return (values.number("speed"),)

    @classmethod
    def fit(cls, robot: int, real: list[list[float]], whole: list[list[int]], values: Values) -> None:
        real[ACCELERATION][robot] = values.number("acceleration")
        real[BRAKING][robot] = values.number("braking")
        real[LENGTH][robot] = values.number("length")
        real[RADIUS][robot] = values.number("length") / 2
        whole[SOLID][robot] = 1
        if values.word("guide") == "road":
            # Robots on different roads keep only their widths apart, else a bend would count as a crash.
            real[RADIUS][robot] = values.number("width") / 2
        else:
            whole[ROAD][robot] = FREE


def take_drive(
    k: int,
    procedure: int,
    percent: int,
    deviate: float,
    actuator: list[list[int]],
    actuator_real: list[list[float]],
    target: list[float],
) -> None:
    """Begins to do what a command says. P is full speed; `deviate` is a normal deviate."""
    speed = 0.0
    if procedure != _STOP:
        speed = percent / 100 * actuator_real[A_P][k]
        factor = 1.0 + deviate * actuator_real[A_NOISE][k]
        if factor < 0.0:
            factor = 0.0
        speed *= factor
    target[actuator[A_ROBOT][k]] = -speed if procedure == _REVERSE else speed
