"""A door that takes its time."""

from __future__ import annotations

from kitrobot.primitives import RobotObject
from kitrobot.sim.columns import A_DONE, A_NOISE, A_P, A_Q, A_R, A_ROBOT, A_S, FAILED
from kitrobot.sim.devices.base import LATENCY, LOST_COMMANDS, Actuator, Setting, Values

DOOR = 2


class Door(Actuator):
    """`Open()` and `Close()`; its place goes from 0 (closed) to 1 (open)."""

    name = "door"
    kind = DOOR
    procedures = ("Close", "Open")
    settings = (
        LATENCY,
        LOST_COMMANDS,
        Setting("time", 1000.0, "how long it takes from closed to open", "ms", 1.0, 3_600_000.0),
        Setting("noise", 0.0, "how far that time may be off (one standard deviation)", "%", 0.0, 50.0),
    )

    @classmethod
    def reals(cls, part: RobotObject, values: Values) -> tuple[float, ...]:
        return 0.0, 0.0, values.number("time") / 1000, values.number("time") / 1000


def take_door(
    k: int, procedure: int, deviate: float, actuator: list[list[int]], actuator_real: list[list[float]]
) -> None:
    """Begins to do what a command says. P is the place, Q where it goes, R the seconds for all of it, S those now."""
    factor = 1.0 + deviate * actuator_real[A_NOISE][k]
    if factor < 0.1:
        factor = 0.1
    actuator_real[A_S][k] = actuator_real[A_R][k] * factor
    actuator_real[A_Q][k] = float(procedure)
    actuator[A_DONE][k] = 0


def move_doors(
    first: int,
    last: int,
    dt: float,
    actuator: list[list[int]],
    actuator_real: list[list[float]],
    down: list[int],
) -> None:
    """Goes on for a step with the devices `first` … `last` - 1."""
    done = actuator[A_DONE]
    for k in range(first, last):
        if done[k] or down[actuator[A_ROBOT][k]] == FAILED:
            continue
        way = actuator_real[A_Q][k] - actuator_real[A_P][k]
        step = dt / actuator_real[A_S][k]
        if abs(way) <= step + 1e-12:
            actuator_real[A_P][k] = actuator_real[A_Q][k]
            done[k] = 1
        elif way > 0.0:
            actuator_real[A_P][k] += step
        else:
            actuator_real[A_P][k] -= step
