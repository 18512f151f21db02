"""A lamp on the robot, for everybody to see."""

from __future__ import annotations

from kitrobot.sim.devices.base import LATENCY, LOST_COMMANDS, Actuator

LAMP_DEVICE = 4


class Lamp(Actuator):
    """`LightOn()`, `LightOff()`."""

    name = "lamp"
    kind = LAMP_DEVICE
    procedures = ("LightOff", "LightOn")
    settings = (LATENCY, LOST_COMMANDS)


def take_lamp(robot: int, procedure: int, lamp: list[int]) -> None:
    """Does what a command says."""
    lamp[robot] = procedure
