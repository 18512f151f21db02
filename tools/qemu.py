"""Find the emulator and the firmware that the board tests run; with `--install`, install them where that is possible.

    python -m tools.qemu              print their paths; status 1 if one is missing
    python -m tools.qemu --install    install them with apt if this is root's Debian, else say what is left out

The firmware is MicroPython for the micro:bit of 2016, as Debian builds it; KITROBOT_QEMU and KITROBOT_FIRMWARE name
others.
"""

from __future__ import annotations

import os
import shutil
import sys
from pathlib import Path
from typing import NamedTuple

from tools import debian

PACKAGES = ("qemu-system-arm", "firmware-microbit-micropython")
FIRMWARE = "/usr/share/firmware-microbit-micropython/firmware.hex"


class Emulator(NamedTuple):
    """The emulator's program and the firmware's file."""

    program: str
    firmware: str


def find() -> Emulator | None:
    """The emulator and the firmware, or None when one of them is missing."""
    program = shutil.which(os.environ.get("KITROBOT_QEMU") or "qemu-system-arm")
    firmware = os.environ.get("KITROBOT_FIRMWARE") or FIRMWARE
    return Emulator(program, firmware) if program and Path(firmware).is_file() else None


def main(arguments: list[str]) -> int:
    if arguments == ["--install"]:
        reason = "" if find() else debian.install(PACKAGES)
        if reason:
            print(f"board tests left out: no QEMU with a micro:bit ({reason}); install {' and '.join(PACKAGES)}")
        return 0
    found = find()
    if found:
        print(*found)
    return 0 if found else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
