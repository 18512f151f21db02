"""A button at the bumper."""

from __future__ import annotations

from kitrobot.sim.devices.base import LATENCY, LOST_READINGS, WRONG, Sensor
from kitrobot.sim.tables.columns import S_ROBOT, S_VALUE, TOUCHING
from kitrobot.sim.tables.state import State


class Button(Sensor):
    """1 while the robot touches a wall or another robot."""

    name = "button"
    settings = (LATENCY, LOST_READINGS, WRONG)


def sense(first: int, last: int, step: int, state: State) -> None:
    """Measures with the devices `first` … `last` - 1."""
    sensor = state.sensors.ints
    robots = sensor[S_ROBOT]
    values = sensor[S_VALUE]
    touching = state.robots.ints[TOUCHING]
    for k in range(first, last):
        values[k] = touching[robots[k]]
