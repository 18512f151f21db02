"""Find the Pico's firmware and boot ROM that the board tests run, or say in one line what is left out without them.

    python -m tools.pico

KITROBOT_PICO_FIRMWARE names a UF2 file of MicroPython for the Raspberry Pi Pico, KITROBOT_PICO_BOOTROM the 16 kB of the
RP2040's boot ROM. No package that could be installed has them.
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import NamedTuple

FIRMWARE, BOOTROM = "KITROBOT_PICO_FIRMWARE", "KITROBOT_PICO_BOOTROM"
LEFT_OUT = f"tests on the Pico's firmware left out: name the files in {FIRMWARE} (a UF2) and {BOOTROM}"


class Firmware(NamedTuple):
    """The files."""

    firmware: Path
    bootrom: Path


def find() -> Firmware | None:
    """The files that are named.

    Raises:
        FileNotFoundError: one that is named is not there.
    """
    named = [os.environ.get(FIRMWARE), os.environ.get(BOOTROM)]
    if not all(named):
        return None
    found = Firmware(*(Path(str(name)) for name in named))
    for path in found:
        if not path.is_file():
            raise FileNotFoundError(path)
    return found


if __name__ == "__main__":
    print(*(find() or (LEFT_OUT,)))
