"""Real robots in the words of a trace: who takes part, what the numbers are, a fault as an event."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from kitrobot.deploy import Fault
from kitrobot.diagnostics import KitRobotError
from kitrobot.trace import TEAM, Column, TraceAgent, TraceHeader
from kitrobot.workspace.board_carried import Carried
from kitrobot.workspace.board_names import BoardNames

BEFORE = ("doing", "forced", "tick")
"""Numbers that stand before the cells of each robot."""


class NoRecordingError(KitRobotError):
    """What the robots run cannot be recorded."""


@dataclass(frozen=True)
class RecordedBoard:
    """Who is recorded: what the robot is called, and its program."""

    name: str
    names: BoardNames
    carried: Carried


def header_of(boards: Sequence[RecordedBoard]) -> TraceHeader:
    """The header of a recording of these robots.

    Raises:
        NoRecordingError: they run programs of several missions.
    """
    first = boards[0]
    if any((one.carried.mission, one.carried.parts) != (first.carried.mission, first.carried.parts) for one in boards):
        raise NoRecordingError(
            "the robots run programs of different missions, and a recording holds one mission",
            "record them one by one, each into a file of its own",
        )
    columns = [Column(one.name, name) for one in boards for name in (*BEFORE, *one.carried.cells)] + [
        Column(TEAM, "collisions")
    ]
    return TraceHeader(
        first.carried.mission,
        0,
        first.carried.world,
        min(one.names.tick_ms for one in boards),
        tuple(
            TraceAgent(one.name, one.names.program, one.names.robot, number=number)
            for number, one in enumerate(boards, 1)
        ),
        tuple(columns),
        {one.names.program: tuple(vertex for vertex, _, _ in one.names.places) for one in boards},
        first.carried.parts,
    )


def fault_said(fault: Fault, names: BoardNames) -> str:
    """A fault as an event: its number, what it means, what the robot says of it, vertex and line."""
    said = names.fault_text(fault.text).strip()
    vertex, line = names.vertex(fault.instruction), names.line(fault.instruction)
    if not line:
        return f"fault {fault.number}: {fault.meaning} ({said})" if said else f"fault {fault.number}: {fault.meaning}"
    place = f"at the vertex {vertex}, line {line} of the code" if vertex else f"at line {line} of the code"
    if said:
        return f"fault {fault.number}: {fault.meaning} ({said}); {place}"
    return f"fault {fault.number}: {fault.meaning}; {place}"
