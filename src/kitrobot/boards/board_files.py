"""Programs as files that a board takes from its drive, made of missions."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path, PurePath

from kitrobot.boards.sent_programs import store_sent_program
from kitrobot.deploy.errors import BoardError
from kitrobot.deploy.microbit_hex.board_hex import BOARD_NAMES, make_board_hex
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.diagnostics.read_files import expect_output
from kitrobot.files.disk import read_bytes, write_atomic
from kitrobot.files.embedded_mission import carried_mission
from kitrobot.files.examples import find_mission
from kitrobot.files.program_formats import Form
from kitrobot.robots.program import BoardProgram
from kitrobot.text.sentences import COMMA, Sentence, Series

HEX = ".hex"


class BoardFileError(KitRobotError):
    """No board takes such a file."""


@dataclass(frozen=True)
class BoardFile:
    """A file for a board's drive. `boards`: for which; `reasons`: of each other board that was tried, why not."""

    data: bytes
    boards: Series
    reasons: tuple[tuple[Sentence, BoardError], ...]


def make_board_file(program: BoardProgram, mission: bytes) -> BoardFile:
    """The universal hex of a program; its names are kept, so that its robot is known later.

    `mission`: the `.krt` that travels along, or nothing.

    Raises:
        KitRobotError: it fits no micro:bit; the message says what takes most.
    """
    made = make_board_hex(program.file, program.package, program.needs, mission)
    store_sent_program(program, program.called)
    names = Series(COMMA, (BOARD_NAMES[number] for number in made.boards))
    return BoardFile(made.data, names, tuple((BOARD_NAMES[number], error) for number, error in made.left_out.items()))


def save_board_file(program: BoardProgram, source: Path, target: Path) -> BoardFile:
    """The same, written to `target`; `source`: the file of the program, whose mission travels along.

    Raises:
        BoardFileError: the name of the target is none of such a file.
        KitRobotError: it fits no micro:bit, or the file cannot be written.
    """
    expect_board_file(target)
    source = find_mission(source)
    expect_output(target, source)
    data, name = carried_mission(read_bytes(source), source.name)
    made = make_board_file(program, data if PurePath(name).suffix.lower() == Form.MISSION.value else b"")
    write_atomic(target, made.data)
    return made


def expect_board_file(target: Path) -> None:
    """That a file's name says which board takes it.

    Raises:
        BoardFileError: it does not.
    """
    if target.suffix.lower() != HEX:
        raise BoardFileError(
            Sentence("`{file}` is no name of a file that a board takes", target),
            Sentence("for a micro:bit let it end in `.hex`; other boards get their program over a cable"),
        )
