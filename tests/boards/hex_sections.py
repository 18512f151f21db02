"""The sections of a file for the drive of a micro:bit, as another library reads them: a board's own Intel Hex."""

from __future__ import annotations

from pathlib import Path

import universal_hex

from kitrobot.deploy.microbit_hex.board_hex import make_board_hex
from kitrobot.deploy.microbit_hex.bundled_firmware import V1
from kitrobot.robots.program import BoardProgram


def section(program: BoardProgram, board: int) -> str:
    """The Intel Hex of one board, as another library takes it out of the universal hex."""
    made = make_board_hex(program.file, program.package, program.needs)
    return str(next(one.hex for one in universal_hex.separate_uhex(made.data.decode()) if one.board_id == board))


def image_2016(program: BoardProgram, folder: Path) -> str:
    """The same as a file; QEMU reads records of the plain form alone."""
    path = folder / "board.hex"
    lines = section(program, V1).splitlines()
    path.write_text("".join(f"{line}\n" for line in lines if line[7:9] in ("00", "01", "04")), encoding="ascii")
    return str(path)
