"""Notices a box on the bed of the robot; a robot with this sensor has a bed and can be loaded."""

from __future__ import annotations

from kitrobot.sim.columns import BED
from kitrobot.sim.devices.base import LATENCY, LOST_READINGS, WRONG, Sensor, Values

CARGO = 2


class Cargo(Sensor):
    """1 while a box lies on the bed."""

    name = "cargo"
    kind = CARGO
    settings = (LATENCY, LOST_READINGS, WRONG)

    @classmethod
    def fit(cls, robot: int, real: list[list[float]], whole: list[list[int]], values: Values) -> None:
        whole[BED][robot] = 1


def sense_cargo(first: int, last: int, robots: list[int], load: list[int], values: list[int]) -> None:
    """Measures with the devices `first` … `last` - 1."""
    for k in range(first, last):
        values[k] = load[robots[k]]
