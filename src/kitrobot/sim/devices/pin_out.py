"""A pin that something unknown to the simulator is wired to: it only remembers what it was told."""

from __future__ import annotations

from kitrobot.sim.devices.base import LATENCY, LOST_COMMANDS, Actuator, Command, Discrete, DisplayKind, Values
from kitrobot.sim.tables.state import State


class PinOut(Actuator):
    """`Write(value)` 0 or 1, `Analog(value)` 0…1023, `Servo(angle)` 0…180 °."""

    name = "pin-out"
    discrete = Discrete.INSTANT
    procedures = ("Write", "Analog", "Servo")
    shown = 2
    outputs = 2
    settings = (LATENCY, LOST_COMMANDS)

    @classmethod
    def display_kind(cls, values: Values) -> DisplayKind:
        return "pin"


def start(k: int, command: Command, deviate: float, state: State) -> None:
    """Does what a command says. Outputs: how it is used (1 written, 2 analogue, 3 servo, 0 not yet), and the value."""
    output = state.actuators.outputs[k]
    output[0] = command.procedure + 1
    output[1] = command.first
