"""Monitoring real robots from a terminal, and recording several of them into one file."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from functools import partial
from pathlib import Path

from kitrobot.boards.programs import load_board_program
from kitrobot.boards.sent_programs import load_sent_program
from kitrobot.deploy.line.board import Hello
from kitrobot.deploy.line.handshake import connect
from kitrobot.diagnostics.read_files import expect_output
from kitrobot.robots.board_operations import NoBoardError
from kitrobot.robots.recording import RobotRecorder
from kitrobot.robots.records import NoRecordingError, RecordedBoard
from kitrobot.robots.session import InstalledProgram
from kitrobot.robots.view import WatchedRobot
from kitrobot.text.sentences import Sentence


def known_program(
    hello: Hello, mission: Path | None = None, program: str | None = None, robot: str | None = None
) -> InstalledProgram | None:
    """What runs on a robot: a program of the mission that is named, else what was kept when it was sent.

    `robot`: what an `.lll` is for, which does not say so itself.

    Raises:
        NoBoardError: the robot runs something else than that mission holds now.
        KitRobotError: the mission cannot be used.
    """
    if mission is None:
        return load_sent_program(hello.program)
    ready = load_board_program(mission, robot=robot, program=program)
    if not ready.is_called(hello.program):
        raise NoBoardError(
            Sentence(
                "the robot runs another program than `{program}` of `{mission}` as it is now",
                ready.names.program,
                mission,
            ),
            Sentence("send it with `kitrobot deploy`, or name the mission as it was sent"),
        )
    return ready.known


@contextmanager
def watched_robot(
    address: str,
    mission: Path | None = None,
    program: str | None = None,
    robot: str | None = None,
    waits: Callable[[], None] = lambda: None,
) -> Iterator[WatchedRobot]:
    """A robot to be watched, with names as `known_program` finds them. `waits` is told when it takes a while.

    Raises:
        KitRobotError: it does not answer, or runs something else than that mission holds now.
    """
    with connect(address, waits=waits) as board:
        yield WatchedRobot(address, board, board.hello, known_program(board.hello, mission, program, robot))


def record_robots(path: Path, watched: Sequence[WatchedRobot], mission: Path | None = None) -> RobotRecorder:
    """Records these robots into a file from their beginning on; whoever asked closes it.

    Raises:
        NoRecordingError: of a robot it is not known which mission it runs, or they are of different ones.
        OutputPlaceError: the recording would be written over a file that was read.
        TraceError: the file cannot be made.
    """
    expect_output(path, mission)
    boards = []
    for one in watched:
        if one.known is None or one.known.recording_context is None:
            raise NoRecordingError(
                Sentence(
                    "a recording brings its mission along, and of what `{address}` runs none is known here", one.address
                ),
                Sentence(
                    "name the mission with --mission; a program that is no mission yet, `kitrobot convert` makes one"
                ),
            )
        boards.append(RecordedBoard(one.address.rpartition("://")[2], one.known.names, one.known.recording_context))
    recorder = RobotRecorder(path, boards)
    for number, one in enumerate(watched):
        one.session.subscribe(partial(recorder.robot_changed, number))
    return recorder
