"""A program as a universal hex: what a micro:bit has after `deploy`, as a file that is copied onto its drive.

The section of each board is its MicroPython with a file system in which KitRobot's files, the program's and the line
that names it lie, and, for a board of 2016, the block with the loop. The mission travels along, so the file opens in
the studio.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from kitrobot.deploy.errors import BoardError, PackageError
from kitrobot.deploy.firmware.requirements import FirmwareRequirements
from kitrobot.deploy.installation.initial_files import initial_files
from kitrobot.deploy.line.receiver import MICROBIT
from kitrobot.deploy.microbit_2016.board_fit import refuse_on_2016
from kitrobot.deploy.microbit_2016.flash_loop import FLASH_LOOP
from kitrobot.deploy.microbit_hex.bundled_firmware import V1, V2, bundled_firmware, compiled_block
from kitrobot.deploy.microbit_hex.file_area import build_area
from kitrobot.deploy.package.board_package import LoopInstaller
from kitrobot.deploy.package.compiled_loop import COMPILED_LOOP
from kitrobot.deploy.package.package import Package
from kitrobot.deploy.package.program_file import ProgramFile
from kitrobot.files.embedded_mission import packed_mission
from kitrobot.files.intel_hex import HexFile, write_hex
from kitrobot.text.sentences import Sentence

BOARD_NAMES = {V1: Sentence("the micro:bit of 2016"), V2: Sentence("the micro:bit V2")}


@dataclass(frozen=True)
class _Board:
    """A kind of board: its way to the loop, bytes of memory that are free on it, and its MicroPython's version."""

    installer: LoopInstaller
    free: int
    micropython: str


_BOARDS = {
    # As a board without files says while it is sent to.
    V1: _Board(FLASH_LOOP, 9696, "1.9.2"),
    # Its heap has 64 kB; nobody has measured it.
    V2: _Board(COMPILED_LOOP, 60000, "1.18"),
}


@dataclass(frozen=True)
class BoardHex:
    """A universal hex. `boards`: numbers of the boards that it is for; `left_out`: why it is not for another."""

    data: bytes
    boards: tuple[int, ...]
    left_out: Mapping[int, BoardError]


def make_board_hex(
    program: ProgramFile, package: Package, needs: FirmwareRequirements | None = None, mission: bytes = b""
) -> BoardHex:
    """The universal hex of a program.

    Args:
        program: the file in which drivers have the names that robots' XML gives them.
        package: where drivers are looked for.
        needs: the firmware that the robot's kit requires.
        mission: the `.krt` that travels along; none where it is empty.

    Raises:
        PackageError: a driver is missing, or is none for a micro:bit.
        BoardError: it fits none of the boards, with what takes most.
    """
    if needs is not None and needs.family not in ("", MICROBIT):
        raise PackageError(
            Sentence("a `.hex` is for a micro:bit, and the kit `{kit}` is for another board", needs.kit),
            Sentence("name the kit of a micro:bit with --board, or send the program over a cable"),
        )
    memories: dict[int, Mapping[int, bytes]] = {}
    left_out: dict[int, BoardError] = {}
    for number, board in _BOARDS.items():
        try:
            memories[number] = _memory(number, board, program, package, needs)
        except BoardError as error:
            left_out[number] = error
    if not memories:
        raise left_out[V2]
    return BoardHex(
        write_hex(HexFile(memories, packed_mission(mission) if mission else b"")), tuple(memories), left_out
    )


def _memory(
    number: int, board: _Board, program: ProgramFile, package: Package, needs: FirmwareRequirements | None
) -> Mapping[int, bytes]:
    if number == V1:
        refuse_on_2016(program, package, needs)
    if needs is not None:
        needs.refuse_older(board.micropython)
    files = initial_files(program, package, MICROBIT, board.installer, board.free)
    firmware = bundled_firmware(number)
    block = compiled_block(firmware) if number == V1 else b""
    area = firmware.area
    outside = {start: run for start, run in firmware.memory.items() if not area.start <= start < area.spare + area.page}
    return dict(sorted({**outside, area.start: build_area(area, files, block)}.items()))
