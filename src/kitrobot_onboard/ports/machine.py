# Boards with MicroPython 1.20 and later (ESP32, RP2040, STM32, …): their link is the line that the prompt uses, be it
# USB or serial. What comes in is polled, so waiting for it lets the processor sleep.

import sys
from select import POLLIN, poll
from time import ticks_add as add  # noqa: F401
from time import ticks_diff as diff  # noqa: F401
from time import ticks_ms as ticks  # noqa: F401

MOST = 64  # bytes that are taken at once, so that a flood does not make a tick late
write = sys.stdout.buffer.write
take = sys.stdin.buffer.read
line = poll()
line.register(sys.stdin, POLLIN)
lamp = None


def read(ms):
    """What came, waiting for it at most so long."""
    data = b""
    while len(data) < MOST and line.poll(0 if data else ms):
        data += take(1) or b""
    return data


def tidy():
    """Here is room enough."""


def identify(on):
    """Lights the board's own lamp, when it has one that goes by that name."""
    global lamp
    try:
        if on:
            from machine import Pin

            pin = Pin("LED")
            lamp = pin, pin.value()
            pin.init(Pin.OUT)
            pin.value(1)
        elif lamp:
            lamp[0].value(lamp[1])
            lamp = None
    except Exception:  # no such lamp
        lamp = None
