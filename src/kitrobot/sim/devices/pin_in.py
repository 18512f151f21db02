"""A pin that something unknown to the simulator is wired to."""

from __future__ import annotations

from kitrobot.sim.devices.base import LATENCY, LOST_READINGS, SPREAD, Sensor


class PinIn(Sensor):
    """0, until somebody puts a number in its place; 0 and 1 for a digital pin, more for an analogue one."""

    name = "pin-in"
    by_hand = True
    settings = (LATENCY, LOST_READINGS, SPREAD)
