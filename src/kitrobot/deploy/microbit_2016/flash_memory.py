"""The memory that a program takes on a micro:bit of 2016, where the loop runs from flash.

The estimate is what programs of the gallery took there (`tools/microbit_kits.py`).
"""

from __future__ import annotations

from kitrobot.deploy.package.board_package import BoardPackage
from kitrobot.deploy.package.memory import image_bytes
from kitrobot.deploy.package.program_file import UNUSED, ProgramFile

_TEXT, _LETTER, _DEVICE = 2.41, 1.09, 136
"""What a program takes where the loop runs from flash, beside its arrays: for a letter of its file that is text, and
for one of its drivers; a device takes so much less than its text says. Fitted to the 48 measured rows of
tools/microbit-2016.json that are of one program."""

OWN_BYTES = 2700
"""What KitRobot itself takes there. 2 950 was found; a program left up to 214 bytes more than that says, and what runs
must never be refused."""


def program_bytes(program: ProgramFile, built: BoardPackage, file_bytes: int) -> int:
    """Bytes that a program takes at least where the loop runs from flash: its arrays, its drivers, its devices."""
    arrays = image_bytes(program.image)
    names = {*built.drivers.values(), *built.bases.values(), *([built.member] if built.member else [])}
    letters = sum(len(built.files[name]) for name in names)
    devices = sum(device.driver != UNUSED and device.kind != "t" for device in program.devices)
    text = max(0, file_bytes - arrays)
    return int(arrays + max(0.0, _TEXT * text - _DEVICE * devices) + _LETTER * letters)
