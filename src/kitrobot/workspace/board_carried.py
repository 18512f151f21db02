"""What a recording of a real robot brings along, so that it opens anywhere: mission, world, parts, names.

A robot knows none of it. It is worked out where the mission is at hand, and kept beside the names of a program that was
sent from here (board_names), so that a robot can be recorded later without saying which mission it was.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from contextlib import suppress
from dataclasses import asdict, dataclass
from typing import Any

from kitrobot.compiler import Compiled
from kitrobot.image import Image, Layout
from kitrobot.image.instructions import ACT
from kitrobot.mission import write_mission
from kitrobot.primitives import Robot
from kitrobot.trace import TracePart
from kitrobot.workspace.board_names import NAME_ON_ROBOT
from kitrobot.workspace.files import FileError, write_atomic
from kitrobot.workspace.journals import state_folder
from kitrobot.workspace.opening import OpenMission
from kitrobot.workspace.traces import parts_of
from kitrobot.world import write_world

_ENDING = ".carried"
_MOST_BYTES = 20_000_000
"""Of what is kept of one program: more is no mission that a board runs."""

Call = tuple[str, str, tuple[int, ...]]
"""A command of a program: actuator, procedure, and its arguments where the program gives fixed numbers."""


@dataclass(frozen=True)
class Carried:
    """For recordings of one program on a robot.

    Attributes:
        mission: the canonical `.krt`, as text.
        world: the file of the world, as text.
        parts: XML files that the mission needs besides.
        cells: what the cells that a robot tells of are called in a recording, from cell 0 on.
        first: what they are before anything is told.
        calls: the instructions that command a device.
    """

    mission: str
    world: str
    parts: tuple[TracePart, ...]
    cells: tuple[str, ...]
    first: tuple[int, ...]
    calls: Mapping[int, Call]


def carried_by(opened: OpenMission, robot: Robot, compiled: Compiled) -> Carried | None:
    """What recordings of a program of that mission carry; None for a mission whose world is not there."""
    if opened.world is None or compiled.image is None:
        return None
    layout = Layout(robot)
    cells = ["fault", *(f"input {name}" for name in layout.sensors), *(f"done {name}" for name in layout.done)]
    cells += [f"variable {name}" for name in layout.variables]
    return Carried(
        write_mission(opened.mission).decode(),
        write_world(opened.world).decode(),
        parts_of(opened),
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


def keep_carried(carried: Carried | None, called: Iterable[str]) -> None:
    """Keeps it for later, where that can be, beside the names; `called`: what robots call the program."""
    folder = state_folder() / "boards"
    text = json.dumps(asdict(carried), ensure_ascii=False) if carried is not None else ""
    with suppress(OSError, FileError):
        for one in called:
            path = folder / f"{one}{_ENDING}"
            if text and len(text) <= _MOST_BYTES:
                write_atomic(path, text.encode())
            else:
                # What was sent last counts, also when it came from no mission.
                path.unlink(missing_ok=True)
        for path in folder.glob(f"*{_ENDING}"):
            if not path.with_suffix(".json").exists():
                path.unlink(missing_ok=True)


def kept_carried(called: str) -> Carried | None:
    """What was kept of a program, by what a robot calls it; None when nothing was."""
    if not NAME_ON_ROBOT.fullmatch(called):
        return None
    try:
        path = state_folder() / "boards" / f"{called}{_ENDING}"
        found: Any = json.loads(path.read_text(encoding="utf-8"))
        return Carried(
            str(found["mission"]),
            str(found["world"]),
            tuple(TracePart(str(part["file"]), str(part["text"])) for part in found["parts"]),
            tuple(map(str, found["cells"])),
            tuple(map(int, found["first"])),
            {
                int(number): (str(actuator), str(procedure), tuple(map(int, arguments)))
                for number, (actuator, procedure, arguments) in found["calls"].items()
            },
        )
    except (OSError, ValueError, KeyError, TypeError, AttributeError):
        return None
