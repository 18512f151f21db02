# From power-on to the loop, in steps that a small board forgets one after the other: this one makes a robot without a
# program; `equip` gives it its devices; `load` its program, which then runs.

import struct

from kitrobot_onboard.state import DUE, FAULT, FORCED, HEARD, NAMES, NEWS, REST, SEEN, SENT, TOLD

LENGTH = 37  # of the list that a robot is


def ready(port, line, robot):
    """Fills the list that a robot is (see `state`).

    `line`: generation, module, program ("-": none), as `kr0` or `kr1` has them.
    """
    robot += [b"", [], [], [], [], [], 0, 0, 0, [], [], "", b""]
    while len(robot) < LENGTH:
        robot.append(0)
    robot[FAULT] = 0, 65535, 0, ""
    robot[FORCED] = {}
    robot[REST] = robot[SENT] = robot[NEWS] = robot[SEEN] = b""
    robot[DUE] = robot[HEARD] = robot[TOLD] = port.ticks()
    robot[NAMES] = struct.pack("<H", line[0]) + bytes(line[1][2:] + " " + (line[2][2:] or "-"), "utf8")
