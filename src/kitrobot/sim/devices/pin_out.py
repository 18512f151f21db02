"""A pin that something unknown to the simulator is wired to: it only remembers what it was told."""

from __future__ import annotations

from kitrobot.sim.devices.base import LATENCY, LOST_COMMANDS, Actuator

PIN_OUT = 6


class PinOut(Actuator):
    """`Write(value)` 0 or 1, `Analog(value)` 0…1023, `Servo(angle)` 0…180 °."""

    name = "pin-out"
    kind = PIN_OUT
    procedures = ("Write", "Analog", "Servo")
    shown = 2
    face = 2
    settings = (LATENCY, LOST_COMMANDS)


def take_pin_out(procedure: int, value: int, face: list[int]) -> None:
    """Does what a command says. The face: how it is used (1 written, 2 analogue, 3 servo, 0 not yet), and the value."""
    face[0] = procedure + 1
    face[1] = value
