"""Notices a box on the bed of the robot; a robot with this sensor has a bed and can be loaded."""

from __future__ import annotations

from kitrobot.sim.devices.base import LATENCY, LOST_READINGS, WRONG, Discrete, Sensor, Values
from kitrobot.sim.tables.columns import BED, LOAD, S_ROBOT, S_VALUE
from kitrobot.sim.tables.state import State


class Cargo(Sensor):
    """1 while a box lies on the bed."""

    name = "cargo"
    discrete = Discrete.EXACT
    settings = (LATENCY, LOST_READINGS, WRONG)

    @classmethod
    def fit(cls, robot: int, floats: list[list[float]], ints: list[list[int]], values: Values) -> None:
        ints[BED][robot] = 1


def sense(first: int, last: int, step: int, state: State) -> None:
    """Measures with the devices `first` … `last` - 1."""
    sensor = state.sensors.ints
    robots = sensor[S_ROBOT]
    values = sensor[S_VALUE]
    load = state.robots.ints[LOAD]
    for k in range(first, last):
        values[k] = load[robots[k]]
