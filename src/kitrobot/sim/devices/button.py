"""A button at the bumper."""

from __future__ import annotations

from kitrobot.sim.devices.base import LATENCY, LOST_READINGS, WRONG, Sensor

BUTTON = 1


class Button(Sensor):
    """1 while the robot touches a wall or another robot."""

    name = "button"
    kind = BUTTON
    settings = (LATENCY, LOST_READINGS, WRONG)


def sense_buttons(first: int, last: int, robots: list[int], touching: list[int], values: list[int]) -> None:
    """Measures with the devices `first` … `last` - 1."""
    for k in range(first, last):
        values[k] = touching[robots[k]]
