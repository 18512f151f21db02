# Boards with MicroPython 1.20 and later (ESP32, RP2040, STM32, …): their link is the line that the prompt uses, be it
# USB or serial. What comes in is polled, so waiting for it lets the processor sleep. What goes out is polled too: USB
# waits up to a second for a host that does not read, and the loop, STOP and the watchdog would wait with it.

import sys
from select import POLLIN, POLLOUT, poll
from time import ticks_add as add  # noqa: F401
from time import ticks_diff as diff  # noqa: F401
from time import ticks_ms as ticks  # noqa: F401

MOST = 64  # bytes that are taken at once, so that a flood does not make a tick late
KEPT = 256  # bytes that wait for a line that takes none
give = sys.stdout.buffer.write
take = sys.stdin.buffer.read
line = poll()
line.register(sys.stdin, POLLIN)
room = poll()
room.register(sys.stdout, POLLOUT)
polled = False  # whether the line ever said that it takes bytes: on some ports it never does, and is not waited for
unsent = b""
lamp = None


def write(data):
    """Gives to the line what it takes without waiting, a byte at a time; how many bytes wait for the next call."""
    global polled, unsent
    data = unsent + data
    at = 0
    while at < len(data):
        if room.poll(0):
            polled = True
        elif polled:
            break
        give(data[at : at + 1])
        at += 1
    unsent = data[at:][-KEPT:]
    return len(unsent)


def read(ms):
    """What came, waiting for it at most so long. What follows a 0x03 is for the prompt, if that was a break."""
    data = b""
    if write(b""):
        ms = min(ms, 2)
    while len(data) < MOST and data[-1:] != b"\3" and line.poll(0 if data else ms):
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
