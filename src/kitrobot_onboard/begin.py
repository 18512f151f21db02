# Fills the list that a robot is (see `state`), in pieces (see `boot`). The port, the devices and the program file have
# made: ticks, diff, add, read, write, tidy, requests, package, generation, program.

import struct

from kitrobot_onboard.state import (
    ACTUATORS,
    ADD,
    COUNT,
    DIFF,
    DUE,
    FAULT,
    FORCED,
    HEARD,
    LATE,
    LENGTH,
    NAMES,
    READ,
    REPORTS,
    REQUESTS,
    REST,
    SEEN,
    SENSORS,
    SPACE,
    STATE,
    TENDS,
    TICKS,
    TIDY,
    WRITE,
)

robot = [None] * LENGTH
robot[TICKS] = ticks
robot[DIFF] = diff
robot[ADD] = add
robot[READ] = read
robot[WRITE] = write
robot[TIDY] = tidy
robot[SENSORS] = []
robot[ACTUATORS] = []
robot[FORCED] = []
robot[REPORTS] = []
robot[TENDS] = []
robot[REQUESTS] = requests
robot[SPACE] = globals()
robot[SEEN] = robot[REST] = b""
robot[COUNT] = robot[LATE] = robot[STATE] = 0
robot[FAULT] = 0, 0, None, None
robot[DUE] = robot[HEARD] = ticks()
robot[NAMES] = struct.pack("<H", generation) + bytes(package + " " + program[2:], "utf8")
at = number = count = device = text = None  # of `requests`: where they are kept is made while there is room
del requests, generation, package
