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
    """What is in a program file: the list that a robot is (see `state`), as far as it comes from there, and a list of
    words for each device.

    Raises ValueError when the file is damaged, OSError when it cannot be read.
    """
    if not is_whole(name):
        raise ValueError("damaged")
    file = open(name, "rb")
    file.readline()
    devices = []
    while True:
        line = file.readline()
        if len(line) < 2:
            break
        devices.append(str(line, "utf8").split())
    fields = struct.unpack(HEADER, file.read(HEADER_SIZE))
    if fields[0] != b"KRI\0" or fields[1] != FORMAT:
        raise ValueError("another format")
    robot = list(arrays(file.read, fields))
    file.close()
    robot.append(robot[1][: 1 + fields[6] + fields[7] + fields[8]])
    robot += [fields[6], 1 + fields[6] + fields[7], fields[4], [], [], "", b""]
    return robot, devices
