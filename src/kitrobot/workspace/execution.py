"""One program against scripted inputs, without a world: what it commands and what its variables become, tick by tick.

The machine is the same as everywhere. Inputs are what the script says, from the tick of each row on; before any row a
sensor is 0 (or the end of its range nearest to 0) and every device is done. Nothing but the script moves them: no
device answers, so a program can be looked at alone.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from kitrobot.image import Image, Machine
from kitrobot.primitives import Robot
from kitrobot.workspace.inputs import Inputs

NO_INPUTS = Inputs()


@dataclass(frozen=True)
class Executed:
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


def execute(image: Image, robot: Robot, ticks: int, inputs: Inputs = NO_INPUTS) -> Iterator[Executed]:
    """Runs an image for exactly `ticks` ticks.

    Raises:
        ImageError: the image was made for another robot, or cannot be run safely; at once, not while iterating.
    """
    return _ticks(Machine(image, robot), ticks, inputs)


def _ticks(machine: Machine, ticks: int, inputs: Inputs) -> Iterator[Executed]:
    for tick in range(ticks):
        for change in inputs.at(tick):
            if change.done:
                machine.set_done(change.name, bool(change.value))
            else:
                machine.set_input(change.name, change.value)
        commands = tuple(
            (f"{command.actuator}.{command.procedure}", tuple(command.arguments)) for command in machine.tick()
        )
        yield Executed(tick, commands, machine.variables(), machine.fault, machine.ended)
