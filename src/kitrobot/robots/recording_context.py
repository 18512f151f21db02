"""The context that recordings of real robots embed, so that they open anywhere: mission, world, parts, names of cells.

A robot knows none of it. It is made where the mission is at hand; `boards.sent_programs` stores it beside the names
of a program that was sent from here, so that a robot can be recorded later without naming its mission.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from kitrobot.compiler.compilation import CompiledProgram
from kitrobot.image.instructions import ACT
from kitrobot.image.machine import Layout
from kitrobot.image.model import Image
from kitrobot.mission.model import Mission
from kitrobot.mission.writer import write_mission
from kitrobot.primitives.robot import Robot
from kitrobot.trace.model import TracePart
from kitrobot.world.model import World
from kitrobot.world.xml_writer import write_world

Call = tuple[str, str, tuple[int, ...]]
"""A command of a program: actuator, procedure, and its arguments where the program gives fixed numbers."""


@dataclass(frozen=True)
class RecordingContext:
    """The context of recordings of one program on a robot.

    Attributes:
        mission: the canonical `.krt`, as text.
        world: the file of the world, as text.
        parts: XML files that the mission needs besides.
        cells: the names in a recording of the cells that a robot reports, from cell 0 on.
        first: their values before the first report.
        calls: the instructions that command a device.
    """

    mission: str
    world: str
    parts: tuple[TracePart, ...]
    cells: tuple[str, ...]
    first: tuple[int, ...]
    calls: Mapping[int, Call]


def recording_context_of(
    mission: Mission, world: World, parts: tuple[TracePart, ...], robot: Robot, compiled: CompiledProgram
) -> RecordingContext | None:
    """What recordings of a program of that mission embed; None for one with errors."""
    if compiled.image is None:
        return None
    layout = Layout(robot)
    cells = ["fault", *(f"input {name}" for name in layout.sensors), *(f"done {name}" for name in layout.done)]
    cells += [f"variable {name}" for name in layout.variables]
    return RecordingContext(
        write_mission(mission).decode(),
        write_world(world).decode(),
        parts,
        tuple(cells),
        tuple(layout.first_values(robot)),
        _calls(compiled.image, layout),
    )


def _calls(image: Image, layout: Layout) -> dict[int, Call]:
    found = {}
    fixed = len(image.cells) - image.constants
    for number in range(image.instructions):
        op, command, first, count = image.code[4 * number : 4 * number + 4]
        if op == ACT:
            _, actuator, procedure = layout.commands[command]
            arguments = tuple(image.cells[first : first + count]) if first >= fixed else ()
            found[number] = (actuator, procedure, arguments)
    return found
