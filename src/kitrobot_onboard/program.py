# Reading a program file (docs/reference/link.md), at power-on, a few bytes at a time. Nothing here is needed
# afterwards: a small board throws it away.

import struct

from kitrobot_onboard.arrays import HEADER, HEADER_SIZE, arrays

FORMAT = 1  # of images


def is_whole(name):
    """Whether a file is a program file and its sum fits."""
    file = open(name, "rb")
    first = file.readline().split()
    a = b = 0
    while True:
        data = file.read(32)
        if not data:
            break
        for x in data:
            a += x
            b += a
        a %= 255
        b %= 255
    file.close()
    return len(first) == 2 and first[0] == b"KRP1" and first[1] == b"%d" % (b << 8 | a)


def load(name):
    """The header's fields, the arrays, where in the file the cells are, and a list of words for each device.

    Raises ValueError when the file is damaged, OSError when it cannot be read.
    """
    if not is_whole(name):
        raise ValueError("damaged")
    file = open(name, "rb")
    at = len(file.readline())
    devices = []
    while True:
        line = file.readline()
        at += len(line)
        if len(line) < 2:
            break
        devices.append(str(line, "utf8").split())
    fields = struct.unpack(HEADER, file.read(HEADER_SIZE))
    if fields[0] != b"KRI\0" or fields[1] != FORMAT:
        raise ValueError("another format")
    loaded = fields, arrays(file.read, fields), at + HEADER_SIZE, devices
    file.close()
    return loaded
