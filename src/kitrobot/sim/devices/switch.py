"""A switch for something that the simulator does not know: it only remembers whether it is on."""

from __future__ import annotations

from kitrobot.sim.devices.base import LATENCY, LOST_COMMANDS, Actuator, Command, Discrete
from kitrobot.sim.tables.columns import A_ACTION
from kitrobot.sim.tables.state import State


class Switch(Actuator):
    """`SwitchOn()`, `SwitchOff()`."""

    name = "switch"
    discrete = Discrete.INSTANT
    procedures = ("SwitchOff", "SwitchOn")
    settings = (LATENCY, LOST_COMMANDS)


def start(k: int, command: Command, deviate: float, state: State) -> None:
    """Does what a command says; A_ACTION is 1 while it is on."""
    state.actuators.ints[A_ACTION][k] = command.procedure
