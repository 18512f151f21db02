"""What every simulated device is: its name in robots' XML, its settings, and loops over all devices of its kind.

A module of this package that defines a subclass with a `name` is a device; nobody keeps a list. `settings` says which
attributes of the robot's XML it understands, with their units and bounds, so that every number of its behaviour is in
the XML. The class only describes; a device's state and numbers are its entries in the tables of the run (see columns),
where `reals` fills the columns P, Q, … that are its own. What it does is in loops beside the class, in the Python that
Numba compiles: a sensor's `sense_…` measures into S_VALUE, an actuator's `take_…` begins what a command says and its
`move_…` goes on for a step. `stepping` calls them. What a device shows to the eye or the ear is its row of `faces`.

What all of them share, latency, noise and drop-outs, is done in one place each: `sampling` for sensors, `commanding`
for actuators; only how noise changes what an actuator does is its own.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar

from kitrobot.primitives import RobotObject


@dataclass(frozen=True)
class Setting:
    """An attribute of a device: a number with a unit and bounds, or one of a few words."""

    name: str
    default: float | str
    help: str
    unit: str = ""
    least: float = 0.0
    most: float = 1_000_000.0
    words: tuple[str, ...] = ()


LATENCY = Setting("latency", 0.0, "how much later it works, or how old what it reads is", "ms", most=60_000.0)
LOST_READINGS = Setting("dropout", 0.0, "how often a reading is lost and the one before stays", "%", 0.0, 100.0)
LOST_COMMANDS = Setting("dropout", 0.0, "how often a command does not reach it", "%", 0.0, 100.0)
SPREAD = Setting("noise", 0.0, "how far a reading may be off (one standard deviation)", "", 0.0, 1000.0)
WRONG = Setting("noise", 0.0, "how often it reads something else than what is there", "%", 0.0, 100.0)


class Values:
    """The settings of one device, each a number or a word."""

    def __init__(self, values: Mapping[str, float | str]) -> None:
        self._values = values

    def number(self, name: str) -> float:
        """A setting that is a number."""
        value = self._values[name]
        assert isinstance(value, float), f"{name} is a word"
        return value

    def word(self, name: str) -> str:
        """A setting that is a word."""
        value = self._values[name]
        assert isinstance(value, str), f"{name} is a number"
        return value

    def says(self, name: str, word: str) -> bool:
        """Whether there is such a setting and it is that word."""
        return self._values.get(name) == word

    def part(self, name: str) -> float:
        """A setting in percent as a part of 1; 0 when there is no such setting."""
        value = self._values.get(name, 0.0)
        assert isinstance(value, float), f"{name} is a word"
        return value / 100


@dataclass(frozen=True)
class Standing:
    """Where an agent was put: its road and dock and storehouse, as numbers in the world's lists, -1 for none."""

    road: int = -1
    dock: int = -1
    storehouse: int = -1


class Device:
    """A kind of device; `kind` is its number among the sensors, or among the actuators, in the order of names."""

    name: ClassVar[str] = ""
    kind: ClassVar[int] = -1
    settings: ClassVar[tuple[Setting, ...]] = ()
    needs: ClassVar[str] = ""
    """Where its robot must start: "road", "dock", "storehouse", or anywhere."""
    excludes: ClassVar[tuple[str, ...]] = ()
    """Devices that a robot with this one cannot have too: they would move the same thing."""
    differs_in: ClassVar[str] = ""
    """A setting in which several devices of this kind on one robot differ."""

    @classmethod
    def reals(cls, part: RobotObject, values: Values) -> tuple[float, ...]:
        """What stands in the columns P, Q, … of one such device at the start; the rest is 0."""
        return ()

    @classmethod
    def fit(cls, robot: int, real: list[list[float]], whole: list[list[int]], values: Values) -> None:
        """What having this device makes of a robot: its size, its bed."""


class Actuator(Device):
    """A device that does something; `procedures` are numbered in the order in which they stand."""

    procedures: ClassVar[tuple[str, ...]] = ()
    face: ClassVar[int] = 0
    """How many whole numbers of its own it has in `faces`, all 0 at the start."""
    shown: ClassVar[int] = 0
    """So many of these, the first ones, are for everybody to see: what a display shows, what a buzzer plays."""


class Sensor(Device):
    """A device that measures."""

    by_hand: ClassVar[bool] = False
    """Whether it measures what only a person does: a run in which somebody waits for that is not at a standstill."""
    restless: ClassVar[bool] = False
    """Whether what it measures changes although nothing else does."""

    @classmethod
    def resting(cls, values: Values) -> int:
        """What it measures where no loop measures for it."""
        return 0


def ticks(time_ms: float, dt: float) -> int:
    """A time in steps, rounded up."""
    return math.ceil(time_ms / (dt * 1000.0) - 1e-9)
