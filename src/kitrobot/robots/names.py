"""Names for the numbers of a real robot: cells → sensors and variables, instructions → vertices and lines of the LLL.

A robot sends numbers only. The names are made where the mission is at hand; `boards.sent_programs` stores them under
the name that the program has on the robot.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass

from kitrobot.compiler.compilation import CompiledProgram
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.image.machine import Layout
from kitrobot.primitives.robot import Robot
from kitrobot.text.sentences import COMMA, Sentence, Series
from kitrobot.text.suggestions import did_you_mean

_DEVICE = re.compile(r"([as])(\d{1,3}) ?(.*)", re.DOTALL)
NAME_ON_ROBOT = re.compile(r"[0-9a-f]{8}")
"""The name of a program on a robot."""


class NoNameError(KitRobotError):
    """A robot has no such sensor or variable."""


@dataclass(frozen=True)
class BoardNames:
    """The names of one program on a robot. `places`: of each instruction the vertex, the line of the LLL, its text."""

    program: str
    robot: str
    tick_ms: int
    sensors: Mapping[str, int]
    variables: Mapping[str, int]
    actuators: tuple[str, ...]
    arguments: tuple[int, ...]
    """How many arguments each command has."""

    places: tuple[tuple[str | None, int, str], ...]
    made_of: Robot | None = None
    """The robot that has these parts, for their labels and units; None where only the names are stored."""

    def named(self, cells: Mapping[int, int]) -> tuple[dict[str, int], dict[str, int]]:
        """Values of variables and of sensors, by their names; cells that are neither are left out."""
        return (
            {name: cells[cell] for name, cell in self.variables.items() if cell in cells},
            {name: cells[cell] for name, cell in self.sensors.items() if cell in cells},
        )

    def input(self, name: str) -> int:
        """The cell of a sensor.

        Raises:
            NoNameError: there is none of that name.
        """
        return _cell(self.sensors, name, Sentence("the robot `{robot}` has no sensor `{sensor}`", self.robot, name))

    def variable(self, name: str) -> int:
        """The cell of a variable.

        Raises:
            NoNameError: there is none of that name.
        """
        return _cell(
            self.variables, name, Sentence("the robot `{robot}` has no variable `{variable}`", self.robot, name)
        )

    def vertex(self, instruction: int | None) -> str | None:
        """The vertex that an instruction came from."""
        return self._place(instruction)[0]

    def line(self, instruction: int | None) -> int:
        """The line of the LLL, from 1, that an instruction came from; 0 when nobody knows."""
        return self._place(instruction)[1]

    def text(self, instruction: int | None) -> str:
        """That line."""
        return self._place(instruction)[2]

    def fault_text(self, text: str) -> str:
        """The text of a fault, with the device by its name instead of its number."""
        found = _DEVICE.fullmatch(text)
        if found is None:
            return text
        number = int(found[2])
        if found[1] == "s":
            name = next((name for name, cell in self.sensors.items() if cell == number), None)
        else:
            name = self.actuators[number] if number < len(self.actuators) else None
        return f"{name}: {found[3]}" if name is not None else text

    def _place(self, instruction: int | None) -> tuple[str | None, int, str]:
        if instruction is None or not 0 <= instruction < len(self.places):
            return None, 0, ""
        return self.places[instruction]


def names_of(program: str, robot: Robot, compiled: CompiledProgram) -> BoardNames:
    """The names of a program that was compiled without errors."""
    layout = Layout(robot)
    source = compiled.source
    places = []
    for origin in compiled.debug.origins:
        line = source.position(origin.start)[0]
        places.append((origin.vertex, line, source.line(line).strip()))
    return BoardNames(
        program,
        robot.name,
        robot.tick_ms,
        layout.sensors,
        layout.variables,
        tuple(part.name for part in robot.actuators),
        tuple(len(robot.calls[actuator, name][1].parameters) for _, actuator, name in layout.commands),
        tuple(places),
        robot,
    )


def _cell(cells: Mapping[str, int], name: str, message: Sentence) -> int:
    if name not in cells:
        has = Sentence("it has: {cells}", Series(COMMA, cells)) if cells else Sentence("it has none")
        raise NoNameError(message, did_you_mean(name, cells) or has)
    return cells[name]
