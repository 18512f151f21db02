"""Programs as files that a board takes from its drive, made of missions."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path, PurePath
from typing import Final, Literal

from kitrobot.boards.sent_programs import store_sent_program
from kitrobot.deploy.errors import BoardError
from kitrobot.deploy.firmware.requirements import EVERYWHERE
from kitrobot.deploy.firmware.uf2 import Firmware, read_firmware
from kitrobot.deploy.line.receiver import MICROBIT
from kitrobot.deploy.microbit_hex.board_hex import BOARD_NAMES, make_board_hex
from kitrobot.deploy.uf2_image.board_uf2 import MEMORY, make_board_uf2
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.diagnostics.read_files import expect_output
from kitrobot.files.disk import read_bytes, write_atomic
from kitrobot.files.embedded_mission import FOR_BOARDS, carried_mission
from kitrobot.files.examples import find_mission
from kitrobot.files.program_formats import Form
from kitrobot.primitives.kit import Kit
from kitrobot.robots.program import BoardProgram
from kitrobot.text.sentences import COMMA, Sentence, Series

Ending = Literal[".hex", ".uf2"]
HEX: Final = ".hex"
UF2: Final = ".uf2"


class BoardFileError(KitRobotError):
    """No board takes such a file."""


@dataclass(frozen=True)
class BoardFile:
    """A file for a board's drive.

    Attributes:
        ending: of its name.
        boards: for which it is.
        steps: what is done with it.
        reasons: of each other board that was tried, why not.
    """

    data: bytes
    ending: Ending
    boards: Series
    steps: Sentence
    reasons: tuple[tuple[Sentence, BoardError], ...] = ()


def make_board_file(program: BoardProgram, mission: bytes, firmware: Firmware | None = None) -> BoardFile:
    """The universal hex of a program, or with a firmware its UF2 file; its names are kept, so that its robot is known
    later.

    `mission`: the `.krt` that travels along, or nothing.

    Raises:
        KitRobotError: it fits no such board; the message says what takes most.
    """
    made = _hex(program, mission) if firmware is None else _uf2(program, mission, firmware)
    store_sent_program(program, program.called)
    return made


def _hex(program: BoardProgram, mission: bytes) -> BoardFile:
    made = make_board_hex(program.file, program.package, program.needs, mission)
    return BoardFile(
        made.data,
        HEX,
        Series(COMMA, (BOARD_NAMES[number] for number in made.boards)),
        Sentence("Plug the board in and copy the file onto its drive `MICROBIT`: the program starts by itself."),
        tuple((BOARD_NAMES[number], error) for number, error in made.left_out.items()),
    )


def _uf2(program: BoardProgram, mission: bytes, firmware: Firmware) -> BoardFile:
    made = make_board_uf2(program.file, program.package, firmware, program.needs, mission)
    return BoardFile(
        made.data,
        UF2,
        Series(COMMA, [Sentence("the board of `{file}` ({chip})", firmware.name, made.chip)]),
        Sentence(
            "Hold the button BOOTSEL while you plug the board in, and copy the file onto the drive that appears: the "
            "program starts by itself. MicroPython {version} comes along, and files on the board are replaced.",
            made.micropython,
        ),
    )


def file_of_kit(kit: Kit) -> Ending | Literal[""]:
    """The ending of the file that the board of a kit takes from its drive, "" where it takes none that is known."""
    if kit.family == MICROBIT:
        return HEX
    return UF2 if kit.chip.upper() in MEMORY else ""


def save_board_file(program: BoardProgram, source: Path, target: Path, firmware: Path | None = None) -> BoardFile:
    """The same, written to `target`; `source`: the file of the program, whose mission travels along; `firmware`: that
    of the MicroPython that comes along in a `.uf2`.

    Raises:
        BoardFileError: the name of the target is none of such a file, or the firmware is missing or not wanted.
        KitRobotError: it fits no such board, or a file cannot be read or written.
    """
    expect_board_file(target)
    brought = _expected_firmware(program, target, firmware)
    source = find_mission(source)
    expect_output(target, source)
    data, name = carried_mission(read_bytes(source), source.name)
    made = make_board_file(program, data if PurePath(name).suffix.lower() == Form.MISSION.value else b"", brought)
    write_atomic(target, made.data)
    return made


def expect_board_file(target: Path) -> None:
    """That a file's name says which board takes it.

    Raises:
        BoardFileError: it does not.
    """
    if target.suffix.lower() not in FOR_BOARDS:
        raise BoardFileError(
            Sentence("`{file}` is no name of a file that a board takes", target),
            Sentence(
                "for a micro:bit let it end in `.hex`, for a board such as the Raspberry Pi Pico in `.uf2`; other "
                "boards get their program over a cable"
            ),
        )


def _expected_firmware(program: BoardProgram, target: Path, firmware: Path | None) -> Firmware | None:
    is_uf2 = target.suffix.lower() == UF2
    if firmware is None:
        if not is_uf2:
            return None
        raise BoardFileError(
            Sentence("a `.uf2` brings MicroPython along, and its file is not named"),
            Sentence(
                "fetch MicroPython for your board from {href}, and name the file with {option}",
                (program.needs.href if program.needs is not None else "") or EVERYWHERE,
                "`--firmware FILE.uf2`",
            ),
        )
    if not is_uf2:
        raise BoardFileError(
            Sentence("a `.hex` has the MicroPython of the micro:bit already"),
            Sentence("leave {option} out; it belongs to a `.uf2`", "`--firmware`"),
        )
    expect_output(target, firmware)
    return read_firmware(firmware)
