"""A number that a person sets with a slider."""

from __future__ import annotations

from kitrobot.sim.devices.base import LATENCY, LOST_READINGS, SPREAD, ManualControl, Sensor, Setting, Values
from kitrobot.text.sentences import Sentence


class Slider(Sensor):
    """The number that a person sets with a slider in the arena, or that is put in its place."""

    name = "slider"
    by_hand = True
    settings = (
        LATENCY,
        LOST_READINGS,
        SPREAD,
        Setting("initial", 0.0, Sentence("the number before anybody sets it"), "", -1_000_000_000.0, 1_000_000_000.0),
    )

    @classmethod
    def manual_control(cls, values: Values) -> ManualControl:
        return "slider"

    @classmethod
    def resting(cls, values: Values) -> int:
        return round(values.number("initial"))
