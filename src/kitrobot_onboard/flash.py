# The receiver's access to the flash of the micro:bit of 2016 outside its files, loaded on that board only. Its
# processor is an nRF51: a word of erased flash (all ones) is written by storing it while that is allowed, and a page of
# 1024 bytes is erased by storing its address.

from machine import mem8, mem32

CONFIG = 0x4001E504  # 0: read only, 1: writing, 2: erasing
ERASE = 0x4001E508


def g(at, step, count):
    """So many bytes of memory, from `at` in steps."""
    data = bytearray(count)  # no generator: there is stack for no more than one call in here
    for i in range(count):
        data[i] = mem8[at]
        at += step
    return bytes(data)


def k(at):
    """Erases a page."""
    mem32[CONFIG] = 2
    mem32[ERASE] = at
    mem32[CONFIG] = 0


class Flash:
    """What a file is to the receiver, at a place in flash: words of four bytes."""

    def write(self, data):
        mem32[CONFIG] = 1
        for i in range(0, len(data), 4):
            mem32[self.at] = data[i] | data[i + 1] << 8 | data[i + 2] << 16 | data[i + 3] << 24
            self.at += 4
        mem32[CONFIG] = 0

    def close(self):
        pass


def w(at):
    """Opens the flash from there on for the next requests."""
    global file
    file = Flash()
    file.at = at
