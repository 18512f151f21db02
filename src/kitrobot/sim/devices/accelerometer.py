"""Feels how the board lies: one axis of an accelerometer, or whether it is shaken."""

from __future__ import annotations

from kitrobot.sim.devices.base import LATENCY, LOST_READINGS, SPREAD, ManualControl, Sensor, Setting, Values
from kitrobot.text.sentences import Sentence

_LEVEL_MG = -1024


class Accelerometer(Sensor):
    """The pull along an axis in thousandths of the earth's, or 1 while the board is shaken; in the simulator it lies
    level and still (x and y 0, z −1024), until somebody puts a number in its place.
    """

    name = "accelerometer"
    by_hand = True
    settings = (
        LATENCY,
        LOST_READINGS,
        SPREAD,
        Setting("what", "axis", Sentence("what it feels"), words=("axis", "shake")),
        Setting("axis", "x", Sentence("along which axis"), words=("x", "y", "z")),
    )

    @classmethod
    def manual_control(cls, values: Values) -> ManualControl:
        return "gesture" if values.says("what", "shake") else ""

    @classmethod
    def resting(cls, values: Values) -> int:
        return _LEVEL_MG if values.says("what", "axis") and values.says("axis", "z") else 0
