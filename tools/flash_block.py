"""Compile the loop for the micro:bit of 2016, as hex files bring it: in the emulator, on the firmware that they bring.

    python -m tools.flash_block            say whether the kept block is that of these sources; status 1 if not
    python -m tools.flash_block --write    compile it and keep it (a minute; needs QEMU)

A test says when it is stale: what a board runs from flash has changed (`kitrobot.deploy.microbit_2016.flash_loop`).
"""

from __future__ import annotations

import json
import sys
from base64 import b64encode
from pathlib import Path

from kitrobot.deploy.errors import FirmwareError
from kitrobot.deploy.line.line import Line
from kitrobot.deploy.line.receiver import Receiver
from kitrobot.deploy.line.repl import RawRepl
from kitrobot.deploy.microbit_2016 import shipped
from kitrobot.deploy.microbit_2016.flash import Flash
from kitrobot.deploy.microbit_2016.flash_code import CHUNK
from kitrobot.deploy.microbit_2016.flash_install import freeze
from kitrobot.deploy.microbit_2016.flash_loop import loop_block
from kitrobot.deploy.microbit_hex.bundled_firmware import (
    BLOCK_FILE,
    V1,
    bundled_firmware,
    compiled_block,
    firmware_file,
)

KEPT = Path(shipped.__path__[0], BLOCK_FILE)
_LETTERS = 76


def compile_block() -> bytes:
    """The block, as the board has it in its flash."""
    from tests.boards.qemu import running

    with running(firmware=str(firmware_file(V1))) as board:
        line = Line(board.address)
        try:
            receiver = Receiver(RawRepl(line))
            receiver.begin()
            one = loop_block()
            freeze(receiver, one, set())
            receiver.write("here", bytes(2 * CHUNK))  # a file of several pieces says where the files are
            flash = Flash.of(receiver)
            assert flash is not None
            at = flash.find(one.sign)
            assert at is not None, "it is not where it was written"
            return flash.read(at, CHUNK * flash.pieces_of(one.sign))
        finally:
            line.close()


def main(arguments: list[str]) -> int:
    firmware = bundled_firmware(V1)
    if arguments == ["--write"]:
        text = b64encode(compile_block()).decode()
        lines = [text[at : at + _LETTERS] for at in range(0, len(text), _LETTERS)]
        kept = {"firmware": firmware.digest, "loop": loop_block().name, "block": lines}
        KEPT.write_text(json.dumps(kept, indent=1) + "\n", encoding="utf-8")
        return 0
    try:
        compiled_block(firmware)
    except FirmwareError as error:
        print(error)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
