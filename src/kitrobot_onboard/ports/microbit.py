# The micro:bit of 2016: its link is the USB serial line at 115200 baud; 64 bytes are buffered, without flow control.

import gc

import micropython
from microbit import display, sleep, uart
from utime import ticks_add as add
from utime import ticks_diff as diff
from utime import ticks_ms as ticks

from kitrobot_onboard import start  # noqa: F401  main.py takes it from here

driver = __import__
write = uart.write
micropython.kbd_intr(-1)  # from now on, 0x03 is a byte like any other; main.py undoes it


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
    """What is dark becomes bright, and the other way; the second time undoes the first."""
    for i in range(25):
        display.set_pixel(i % 5, i // 5, 9 - display.get_pixel(i % 5, i // 5))
