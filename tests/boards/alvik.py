"""What an Arduino Alvik's STM32 and its board say to each other, made apart from the driver: frames of ucPack."""

from __future__ import annotations

import struct


def checksum(data: bytes) -> int:
    """CRC-8 of Maxim, bit by bit."""
    found = 0
    for value in data:
        for bit in range(8):
            odd = (found ^ value >> bit) & 1
            found = found >> 1 ^ (0x8C if odd else 0)
    return found


def frame(code: str, form: str, *values: float) -> bytes:
    """`form`: of the values, as `struct` has it."""
    data = code.encode() + struct.pack(f"<{form}", *values)
    return bytes([0x41, len(data)]) + data + bytes([0x23, checksum(data)])


STANDING = frame("x", "B", 0)
TURNED = frame("x", "B", ord("R"))
HEARD = frame("X", "B", ord("K"))
NOTHING = b"".join(
    (
        STANDING,
        frame("l", "3h", 40, 40, 40),
        frame("t", "B", 0),
        frame("c", "3h", 300, 340, 340),
        frame("f", "7h", *[2000] * 7),
    )
)
"""One that sees nothing: bright ground, nobody near, no finger."""
