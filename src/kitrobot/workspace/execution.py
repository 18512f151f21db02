"""Execution of one program with scripted inputs and without a world: its commands and variables, tick by tick.

The machine is the same as everywhere. Inputs come from the script, each row from its tick on; before the first row a
sensor is 0 (or the end of its range nearest to 0) and every device is done. Only the script changes inputs: no device
answers, so a program can be examined alone.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from kitrobot.image.devices import Command, Readings
from kitrobot.image.machine import Machine
from kitrobot.image.model import Image
from kitrobot.primitives.robot import Robot
from kitrobot.workspace.inputs import Inputs

NO_INPUTS = Inputs()


@dataclass(frozen=True)
class ExecutionTick:
    """One tick: the commands handed to the devices, in their order, and what holds after it.

    `variables` is in the order of the robot's file, a boolean as 0 or 1; `fault` is 1 once a value was clamped;
    `ended` says whether the program's own thread has ended.
    """

    tick: int
    commands: tuple[tuple[str, tuple[int, ...]], ...]
    variables: Mapping[str, int]
    fault: int
    ended: bool

    def to_json(self) -> dict[str, Any]:
        """As plain values, in the published shape."""
        return {
            "tick": self.tick,
            "commands": [[name, list(arguments)] for name, arguments in self.commands],
            "variables": dict(self.variables),
            "fault": self.fault,
            "ended": self.ended,
        }


def execute(image: Image, robot: Robot, ticks: int, inputs: Inputs = NO_INPUTS) -> Iterator[ExecutionTick]:
    """Runs an image for exactly `ticks` ticks.

    Raises:
        ImageError: the image was made for another robot, or cannot be run safely; at once, not while iterating.
    """
    return _ticks(Machine(image, robot), ticks, inputs)


class ScriptedDevices:
    """Devices without a world: inputs are those of a script, commands are kept for the caller."""

    def __init__(self, inputs: Inputs = NO_INPUTS) -> None:
        self.tick = 0
        self.applied: Sequence[Command] = ()
        """The commands of the last tick."""
        self._inputs = inputs

    def read(self) -> Readings:
        """The changes of the script in this tick."""
        changes = self._inputs.at(self.tick)
        return Readings(
            {change.name: change.value for change in changes if not change.done},
            {change.name: bool(change.value) for change in changes if change.done},
        )

    def apply(self, commands: Sequence[Command]) -> None:
        """Keeps the commands, and goes on to the next tick."""
        self.applied = commands
        self.tick += 1


def _ticks(machine: Machine, ticks: int, inputs: Inputs) -> Iterator[ExecutionTick]:
    devices = ScriptedDevices(inputs)
    for tick in range(ticks):
        machine.react(devices)
        commands = tuple((f"{one.actuator}.{one.procedure}", tuple(one.arguments)) for one in devices.applied)
        yield ExecutionTick(tick, commands, machine.variables(), machine.fault, machine.ended)
