# The micro:bit of 2016: its link is the USB serial line at 115200 baud; 64 bytes are buffered, without flow control.

import gc

import micropython
from microbit import display, sleep, uart
from utime import ticks_add as add
from utime import ticks_diff as diff
from utime import ticks_ms as ticks

from kitrobot_onboard.start import start

BYTE_US = 87
driver = __import__
write = uart.write
kept = [0] * 25  # what the display showed before it identified itself


def read(ms):
    """What came, waiting for it at most so long."""
    end = add(ticks(), ms)
    while not uart.any():
        if diff(end, ticks()) <= 0:
            return b""
        sleep(1)
    return uart.read()


def free():
    gc.collect()
    return gc.mem_free()


def identify(on):
    for i in range(25):
        if on:
            kept[i] = display.get_pixel(i % 5, i // 5)
        display.set_pixel(i % 5, i // 5, 9 if on else kept[i])


def enter():
    """From now on, 0x03 is a byte like any other."""
    micropython.kbd_intr(-1)


def leave():
    micropython.kbd_intr(3)


def main(package, program, generation):
    start(__import__(__name__), package, program, generation)
