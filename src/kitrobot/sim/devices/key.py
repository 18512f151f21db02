"""A push button that a person holds."""

from __future__ import annotations

from kitrobot.sim.devices.base import LATENCY, LOST_READINGS, WRONG, ManualControl, Sensor, Values


class Key(Sensor):
    """1 while a person holds it: in the simulator while somebody puts a 1 in its place."""

    name = "key"
    by_hand = True
    settings = (LATENCY, LOST_READINGS, WRONG)

    @classmethod
    def manual_control(cls, values: Values) -> ManualControl:
        return "button"
