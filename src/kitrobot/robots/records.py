"""Real robots as records of a trace: the header, and the numbers of one robot in a record.

A robot's numbers are `BEFORE` and then the cells that it reports, as its `RecordingContext` names them. It has no
numbers for its place: nobody knows where a real robot is, which distinguishes it from a simulated one.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.primitives.image_name import ImageName
from kitrobot.robots.faults import describe_fault
from kitrobot.robots.names import BoardNames
from kitrobot.robots.recording_context import RecordingContext
from kitrobot.robots.state import RobotState
from kitrobot.text.sentences import Sentence
from kitrobot.trace.model import TEAM, Column, Threads, TraceAgent, TraceHeader

BEFORE = ("doing", "forced", "tick")
"""Numbers that stand before the cells of each robot."""
IDLE, RUNNING, FAILED, SILENT = 0, 2, 3, 4
"""What a robot does, by the numbers of simulated ones."""
_DOING = {"running": RUNNING, "fault": FAILED}


class NoRecordingError(KitRobotError):
    """What the robots run cannot be recorded."""


@dataclass(frozen=True)
class RecordedBoard:
    """Who is recorded: what the robot is called, and its program."""

    name: str
    names: BoardNames

    recording_context: RecordingContext


def refuse_several_missions(boards: Sequence[RecordedBoard]) -> None:
    """Whether these robots fit into one recording.

    Raises:
        NoRecordingError: they run programs of several missions.
    """
    first = boards[0]
    if any(
        (one.recording_context.mission, one.recording_context.parts)
        != (first.recording_context.mission, first.recording_context.parts)
        for one in boards
    ):
        raise NoRecordingError(
            Sentence("the robots run programs of different missions, and a recording holds one mission"),
            Sentence("record them one by one, each into a file of its own"),
        )


def header_of(boards: Sequence[RecordedBoard]) -> TraceHeader:
    """The header of a run of these robots, with the mission of the first one."""
    first = boards[0]
    columns = [Column(one.name, name) for one in boards for name in (*BEFORE, *one.recording_context.cells)] + [
        Column(TEAM, "collisions")
    ]
    return TraceHeader(
        first.recording_context.mission,
        0,
        first.recording_context.world,
        min(one.names.tick_ms for one in boards),
        tuple(
            TraceAgent(one.name, one.names.program, one.names.robot, number=number)
            for number, one in enumerate(boards, 1)
        ),
        tuple(columns),
        {ImageName(one.names.program): tuple(vertex for vertex, _, _ in one.names.places) for one in boards},
        first.recording_context.parts,
    )


def first_row(robot: RecordedBoard) -> list[int]:
    """The numbers of a robot of which nothing was heard yet."""
    return [0] * len(BEFORE) + list(robot.recording_context.first)


def row_of(robot: RecordedBoard, state: RobotState) -> list[int]:
    """The numbers of a robot."""
    row, sensors = first_row(robot), robot.names.sensors
    cells = {**state.cells, **{sensors[name]: value for name, value in state.forced.items()}}
    for cell, value in cells.items():
        if 0 <= cell < len(robot.recording_context.cells):
            row[len(BEFORE) + cell] = value
    forced = sum(1 << bit for bit, name in enumerate(sensors) if name in state.forced)
    row[: len(BEFORE)] = SILENT if state.lost else _DOING.get(state.doing, IDLE), forced, state.tick
    return row


def active_of(state: RobotState) -> Threads:
    """Where the threads of a robot stand; of one that failed, where that was."""
    if state.doing == "fault" and not state.lost:
        at = state.fault.instruction if state.fault is not None else None
        return ((0, at),) if at is not None else ()
    return tuple(sorted(state.threads.items()))


def sentence_of(robot: RecordedBoard, state: RobotState) -> str:
    """Why a robot goes on no more, "" while nothing is wrong."""
    if state.lost or state.fault is None:
        return state.lost
    return describe_fault(state.fault, robot.names)
