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

BEFORE = f"""
from kitrobot_onboard.drivers.machine.shared import alvik
STANDING, TURNED = {STANDING!r}, {TURNED!r}
class Clock:  # stands, but for sleep
    now = 1000
    slept = 0
    @staticmethod
    def ticks_ms(): return Clock.now
    @staticmethod
    def ticks_diff(end, start): return end - start
    @staticmethod
    def sleep_ms(ms):
        Clock.now += ms
        Clock.slept += ms
alvik.time = Clock
said = []  # what the STM32 says, a piece at each look
def stm32(data):
    return said.pop(0) if said and not data else b""
machine.partners[1] = stm32
def begin_alvik(*pieces):
    alvik.robots.clear()
    levels[13] = 1
    said[:] = pieces or (b"", STANDING)
def ready():
    begin_alvik()
    robot = alvik.robot()
    taken()
    Clock.slept = 0
    return robot
def written():
    return [value for name, what, value in taken() if what == "write"]
def error_of(call, *arguments):
    try:
        return call(*arguments)
    except OSError as error:
        return str(error)
result = None
"""
"""Goes before steps on a current MicroPython (see `kit_steps`): an STM32 that says what a step gives it, and a clock
that stands."""
