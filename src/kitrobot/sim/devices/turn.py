"""A motor that turns the robot on the spot, counter-clockwise."""

from __future__ import annotations

import math

from kitrobot.primitives import RobotObject
from kitrobot.sim.columns import A_DONE, A_NOISE, A_P, A_Q, A_R, A_ROBOT, FAILED
from kitrobot.sim.devices.base import LATENCY, LOST_COMMANDS, Actuator, Setting, Values

TURN_DEVICE = 8
_STOP, _TURN, _ABSOLUTE = range(3)


class Turn(Actuator):
    """`AbsoluteTurn(angle, speed)` turns by a part of a full turn, `Turn(speed)` goes on until `Stop()`; in percent."""

    name = "turn"
    kind = TURN_DEVICE
    procedures = ("Stop", "Turn", "AbsoluteTurn")
    settings = (
        LATENCY,
        LOST_COMMANDS,
        Setting("rate", 180.0, "full turning speed", "°/s", 1.0, 36_000.0),
        Setting("noise", 0.0, "how far an angle or a speed may be off (one standard deviation)", "%", 0.0, 50.0),
    )

    @classmethod
    def reals(cls, part: RobotObject, values: Values) -> tuple[float, ...]:
        return (math.radians(values.number("rate")),)


def take_turn(
    k: int,
    procedure: int,
    count: int,
    first: int,
    last: int,
    deviate: float,
    actuator: list[list[int]],
    actuator_real: list[list[float]],
) -> None:
    """Begins to do what a command says. P is the full rate, Q the rate now, R the angle that is left."""
    factor = 1.0 + deviate * actuator_real[A_NOISE][k]
    if factor < 0.0:
        factor = 0.0
    rate = 0.0
    if count > 0 and procedure != _STOP:
        rate = last / 100 * actuator_real[A_P][k]
    if procedure == _ABSOLUTE:
        actuator_real[A_R][k] = first / 100 * (2.0 * math.pi) * factor
        actuator[A_DONE][k] = 0
    else:
        rate *= factor
        actuator_real[A_R][k] = math.inf
        actuator[A_DONE][k] = 1
    actuator_real[A_Q][k] = rate


def move_turns(
    first: int,
    last: int,
    dt: float,
    actuator: list[list[int]],
    actuator_real: list[list[float]],
    turn: list[float],
    down: list[int],
) -> None:
    """Goes on for a step with the devices `first` … `last` - 1."""
    robots = actuator[A_ROBOT]
    done = actuator[A_DONE]
    rates = actuator_real[A_Q]
    lefts = actuator_real[A_R]
    for k in range(first, last):
        rate = rates[k]
        if (done[k] and rate == 0.0) or down[robots[k]] == FAILED:
            turn[robots[k]] = 0.0
            continue
        step = rate * dt
        left = lefts[k]
        if left < step:
            step = left
        turn[robots[k]] = step
        if left < math.inf:
            left -= step
            lefts[k] = left
            if left <= 1e-12:
                rates[k] = 0.0
                done[k] = 1
