"""The devices of one robot as a host gives them to its machine: readings before a tick, commands after it.

`Machine.react` is the only place where a host's readings enter the cells and commands leave them. A fleet's step is
compiled over tables (`kitrobot.sim`), and a board's loop runs in MicroPython (`kitrobot_onboard.reaction`); both keep
the same order: read, tick, apply.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple, Protocol


class Command(NamedTuple):
    """A command for a device, the thread slot that gave it, and the instruction that did."""

    actuator: str
    procedure: str
    arguments: list[int]
    slot: int
    instruction: int


class Readings(NamedTuple):
    """Inputs by name; one that is missing keeps its value. Sensors are clamped to their ranges.

    `done`: whether an actuator has completed its last procedure.
    """

    sensors: Mapping[str, int] = {}
    done: Mapping[str, bool] = {}


class Devices(Protocol):
    """The sensors and actuators of one robot."""

    def read(self) -> Readings:
        """The inputs of the next tick."""

    def apply(self, commands: Sequence[Command]) -> None:
        """Executes the commands of a tick: at most one for each actuator, in the order of the robot's file."""
