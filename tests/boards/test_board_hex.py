"""Files for the drive of a micro:bit start by themselves and do what a program does that was sent.

The section of the board of 2016 runs on its own firmware in QEMU. There is no V2: its files run on a current
MicroPython that poses as one, whose flash has only what was read out of the V2's section by a library that is not ours.
"""

from __future__ import annotations

from pathlib import Path

import micropython_microbit_fs
import pytest

from kitrobot.boards.programs import load_board_program
from kitrobot.deploy.installation.deployment import deploy
from kitrobot.deploy.line.handshake import connect
from kitrobot.deploy.microbit_hex.board_hex import make_board_hex
from kitrobot.deploy.microbit_hex.bundled_firmware import V1, V2
from kitrobot.robots.program import BoardProgram
from kitrobot.workspace.robots import find_robot
from tests.boards.hex_sections import image_2016, section
from tests.boards.qemu import Emulated, booted
from tests.boards.test_microbit_v2 import board as v2_board
from tests.boards.test_microbit_v2 import goes_on
from tests.boards.test_ticks import compared
from tests.effort import THOROUGH
from tests.patience import PATIENCE_S
from tests.verifier.check_fixtures import EXAMPLES
from tools.microbit_kits import sendable, small_kits

TICKS = 2000 if THOROUGH else 25


def it_runs(board: Emulated, program: BoardProgram) -> None:
    with connect(board.address, PATIENCE_S) as link:
        assert (link.hello.state, link.hello.generation) == (2, 1), "it runs, and nobody has sent anything"
        assert link.hello.program in program.called
        assert link.last_fault() is None


@pytest.mark.boards
def test_the_hex_of_the_heart_starts_and_does_the_ticks_of_a_heart_that_was_sent(tmp_path: Path) -> None:
    program = load_board_program(EXAMPLES / "heart" / "heart.krt")
    with booted(firmware=image_2016(program, tmp_path)) as board:
        it_runs(board, program)
        compared(board.address, program, find_robot("microbit"), seed=13, ticks=TICKS)
        sending_it_finds_all_of_it_there(board, program)
        board.cut_power()
        it_runs(board, program)


def sending_it_finds_all_of_it_there(board: Emulated, program: BoardProgram) -> None:
    done = deploy(board.address, program.file.to_bytes(), program.package)
    assert (done.sent_files, done.generation) == ((), 1)


@pytest.mark.boards
@pytest.mark.thorough(
    "test_the_hex_of_the_heart_starts_…: one program; that each one's files are those sent: deploy/test_board_hex.py"
)
@pytest.mark.parametrize("kit", sorted(small_kits()))
def test_the_hex_of_each_program_of_the_gallery_is_what_is_sent(tmp_path: Path, kit: str) -> None:
    tried = set()
    for mission, made in sendable(small_kits()[kit]).items():
        for name, program in made:
            made_hex = make_board_hex(program.file, program.package, program.needs)
            if program.file.is_member or V1 not in made_hex.boards:
                continue
            with booted(firmware=image_2016(program, tmp_path)) as board:
                with connect(board.address, PATIENCE_S) as link:
                    assert link.hello.program in program.called, (mission, name)
                sending_it_finds_all_of_it_there(board, program)
            tried.add(mission)
    assert tried


def test_the_files_in_the_section_of_a_v2_start_there_and_the_program_drives() -> None:
    program = load_board_program(EXAMPLES / "square" / "square.krt", kit="cutebot")
    files = {one.name: one.content for one in micropython_microbit_fs.get_files(section(program, V2))}
    with v2_board("nRF52833", files=files) as v2, connect(v2.address, PATIENCE_S) as link:
        assert (link.hello.state, link.hello.generation) == (2, 1)
        assert link.hello.program in program.called
        goes_on(link)
        link.stop()
        assert link.last_fault() is None
