"""A switch for something that the simulator does not know: it only remembers whether it is on."""

from __future__ import annotations

from kitrobot.sim.columns import A_WAY
from kitrobot.sim.devices.base import LATENCY, LOST_COMMANDS, Actuator

SWITCH = 7


class Switch(Actuator):
    """`SwitchOn()`, `SwitchOff()`."""

    name = "switch"
    kind = SWITCH
    procedures = ("SwitchOff", "SwitchOn")
    settings = (LATENCY, LOST_COMMANDS)


def take_switch(k: int, procedure: int, actuator: list[list[int]]) -> None:
    """Does what a command says; A_WAY is 1 while it is on."""
    actuator[A_WAY][k] = procedure
