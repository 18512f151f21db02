"""A lamp on the robot, for everybody to see."""

from __future__ import annotations

from kitrobot.sim.devices.base import LATENCY, LOST_COMMANDS, Actuator, Command, Discrete
from kitrobot.sim.tables.columns import A_ROBOT, SIGN_LAMP, SIGNS
from kitrobot.sim.tables.state import State


class Lamp(Actuator):
    """`LightOn()`, `LightOff()`."""

    name = "lamp"
    discrete = Discrete.INSTANT
    procedures = ("LightOff", "LightOn")
    settings = (LATENCY, LOST_COMMANDS)


def start(k: int, command: Command, deviate: float, state: State) -> None:
    """Does what a command says."""
    signs = state.robots.ints[SIGNS]
    robot = state.actuators.ints[A_ROBOT][k]
    signs[robot] = signs[robot] & ~SIGN_LAMP | SIGN_LAMP * command.procedure
