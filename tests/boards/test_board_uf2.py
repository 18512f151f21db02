"""A file for the drive of a Pico starts by itself there.

Without the Pico's own firmware (`test_pico.py` has it where somebody names it), what the library of littlefs finds in
the flash is the flash of a current MicroPython.
"""

from __future__ import annotations

from kitrobot.boards.programs import load_board_program
from kitrobot.deploy.installation.deployment import deploy
from kitrobot.deploy.line.handshake import connect
from kitrobot.deploy.uf2_image.board_uf2 import make_board_uf2
from tests.boards.modern import ModernBoard, onboard_files
from tests.boards.test_microbit_v2 import goes_on
from tests.deploy.test_board_uf2 import files_of, flash_after, mounted
from tests.deploy.uf2_firmware import micropython
from tests.patience import PATIENCE_S
from tests.verifier.check_fixtures import EXAMPLES


def test_the_files_in_a_uf2_start_there_the_program_drives_and_sending_it_finds_all_of_it_there() -> None:
    program = load_board_program(EXAMPLES / "square" / "square.krt", kit="pico")
    made = make_board_uf2(program.file, program.package, micropython(), program.needs)
    machine = {name: content for name, content in onboard_files().items() if "/" not in name}
    with ModernBoard({**machine, **files_of(mounted(flash_after(made.data)))}) as board:
        with connect(board.address, PATIENCE_S) as link:
            assert (link.hello.state, link.hello.generation) == (2, 1), "it runs, and nobody has sent anything"
            assert link.hello.program in program.called
            goes_on(link)
            assert link.last_fault() is None
        done = deploy(board.address, program.file.to_bytes(), program.package)
        assert (done.sent_files, done.generation) == ((), 1)
