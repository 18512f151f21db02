"""The MicroPython that a hex file brings along: of `micropython-microbit-fs`, and the loop compiled for the older one.

A board of 2016 compiles the loop once, when a program is sent to it over a cable. For a hex file that was done
beforehand, in an emulator with the very firmware (`tools/flash_block.py`): `loop.json` has the block, and the sum of
the firmware whose names it refers to.
"""

from __future__ import annotations

import hashlib
import importlib.util
import json
from base64 import b64decode
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from pathlib import Path

from kitrobot.deploy.errors import FirmwareError
from kitrobot.deploy.microbit_2016.flash_loop import loop_block
from kitrobot.deploy.microbit_hex.file_area import FileArea, area_of_firmware
from kitrobot.files.intel_hex import PLAIN, HexError, read_hex
from kitrobot.text.sentences import Sentence

PACKAGE = "micropython_microbit_fs"
BLOCK_FILE = "loop.json"
V1, V2 = 0x9900, 0x9903
"""The numbers of the boards: that of 2016, and V2."""

_FOLDERS = {V1: "microbitv1", V2: "microbitv2"}
_LIBRARY = Sentence(
    "install it with {command}; a page without an installed KitRobot needs the network for it",
    "`pip install micropython-microbit-fs`",
)


@dataclass(frozen=True)
class BundledFirmware:
    """A firmware: its memory as in `HexFile`, the place of its files, its sum, and what it calls its version."""

    memory: Mapping[int, bytes]
    area: FileArea
    digest: str
    version: str


@cache
def bundled_firmware(board: int) -> BundledFirmware:
    """The MicroPython for a board.

    Raises:
        FirmwareError: the package that brings it is not there, or brings one that is not known.
    """
    found = firmware_file(board)
    data = found.read_bytes()
    try:
        memory = read_hex(data, found.name).boards[PLAIN]
    except (HexError, KeyError):
        raise FirmwareError(Sentence("`{file}` is damaged", found), _LIBRARY) from None
    return BundledFirmware(memory, area_of_firmware(memory), hashlib.sha256(data).hexdigest(), found.parent.name[1:])


def firmware_file(board: int) -> Path:
    """The file of the MicroPython for a board.

    Raises:
        FirmwareError: it is not there.
    """
    there = importlib.util.find_spec(PACKAGE)  # imported it is not: it brings more than is needed here
    folders = there.submodule_search_locations if there is not None else None
    for folder in folders or ():
        for path in sorted(Path(folder, "hexes", _FOLDERS[board]).glob("v*/*.hex")):
            return path
    raise FirmwareError(Sentence("the MicroPython for the micro:bit is not installed here"), _LIBRARY)


def compiled_block(firmware: BundledFirmware) -> bytes:
    """The block of flash with the loop for a board of 2016.

    Raises:
        FirmwareError: it was compiled for another firmware, or from another KitRobot.
    """
    kept = json.loads((files("kitrobot.deploy.microbit_2016") / "shipped" / BLOCK_FILE).read_text(encoding="utf-8"))
    if kept["firmware"] != firmware.digest or kept["loop"] != loop_block().name:
        raise FirmwareError(
            Sentence("KitRobot's loop was not compiled for MicroPython {version} of the micro:bit", firmware.version),
            Sentence("send the program over a cable, or install KitRobot anew"),
        )
    return b64decode("".join(kept["block"]))
