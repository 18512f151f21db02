# The micro:bit of 2016: its link is the USB serial line at 115200 baud; 64 bytes are buffered, without flow control.

from gc import collect as tidy  # noqa: F401

from microbit import sleep, uart
from utime import ticks_add as add
from utime import ticks_diff as diff
from utime import ticks_ms as ticks

write = uart.write


def read(ms):
    """What came, waiting for it at most so long."""
    end = add(ticks(), ms)
    while not uart.any():
        if diff(end, ticks()) <= 0:
            return b""
        sleep(1)
    data = uart.read(1)
    while uart.any() and data[-1] != 3:  # what follows a break is for the prompt
        data += uart.read(1)
    return data
