"""How many cycles of a Cortex-M0 an instruction takes, where QEMU counts one: in a robot's ticks.

    python -m benchmarks.m0_cycles

The instructions that the emulated processor does while `square` drives are logged, and counted by the table of cycles
in ARM's Cortex-M0 Technical Reference Manual (3.3, instruction set summary): memory and multiplier that do not make it
wait, and without entering interrupts, so it is the least that the chip takes.
"""

from __future__ import annotations

import re
import time
from collections.abc import Sequence
from itertools import pairwise
from pathlib import Path

from benchmarks.firmware_probe import open_probe
from benchmarks.microbit_ticks import largest_program
from kitrobot.deploy.installation.deployment import deploy
from tools import qemu
from tools.microbit_kits import small_kits

BYTES = 100_000_000
"""Of the log: about a million and a half instructions, some ticks."""

_DONE = re.compile(rb"^Trace \d+: \S+ \[[0-9a-f]+/([0-9a-f]+)/", re.MULTILINE)


def flash_of(firmware: Path) -> bytes:
    """What a firmware's file puts into the flash."""
    flash, base = bytearray(b"\xff" * 0x40000), 0
    for line in firmware.read_text(encoding="ascii").splitlines():
        record = bytes.fromhex(line[1:])
        size, address, kind = record[0], int.from_bytes(record[1:3], "big"), record[3]
        if kind == 4:
            base = int.from_bytes(record[4:6], "big") << 16
        elif kind == 0 and base + address < len(flash):
            flash[base + address : base + address + size] = record[4 : 4 + size]
    return bytes(flash)


def cycles(code: int, goes_on: bool) -> int:
    """Of one instruction of Thumb, whose first half is `code`. `goes_on`: the one behind it is done next."""
    count = (code & 0xFF).bit_count()
    if code >> 8 in (0xB4, 0xB5, 0xBC):  # push, pop
        return 1 + count + (code >> 8 == 0xB5)
    if code >> 8 == 0xBD:  # pop with the place to return to
        return 5 + count
    if code >> 12 == 0xC:  # several loads, stores
        return 1 + count
    if 0x48 <= code >> 8 <= 0x9F:  # loads, stores
        return 2
    if code >> 11 >= 0x1D:  # in two halves: calls, barriers
        return 4
    return 1 if goes_on else 3


def mean(places: Sequence[int], flash: bytes) -> tuple[float, int]:
    """Cycles an instruction, of those that were done in this order, as far as they are in the flash; and how many."""
    total = number = 0
    for at, after in pairwise(places):
        if at < len(flash) - 4:
            code = int.from_bytes(flash[at : at + 2], "little")
            total += cycles(code, after == at + 2)
            number += 1
    return total / number, number


def main() -> None:
    """Prints it."""
    program = largest_program("square/square", small_kits()["cutebot"])
    with open_probe() as found:
        deploy(found.board.address, program.file.to_bytes(), program.package, fresh=True)
        begin = found.written()
        found.tell_emulator("singlestep on")
        found.tell_emulator("log unimp,exec,nochain")
        while found.written() < begin + BYTES:
            time.sleep(0.1)
        found.tell_emulator("log unimp")
        text = found.logged(begin, begin + BYTES)
    firmware = qemu.find()
    assert firmware is not None
    places = [int(place, 16) for place in _DONE.findall(text)]
    each, number = mean(places, flash_of(Path(firmware.firmware)))
    print(f"{number} instructions, {each:.2f} cycles each: {each * 62.5:.0f} ns at 16 MHz, where the emulator takes 64")


if __name__ == "__main__":
    main()
