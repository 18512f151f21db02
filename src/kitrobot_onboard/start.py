# From power-on to the loop. The order is what makes it fit a small board: the interpreter and the loop first, as long
# as there is room to compile them; then the program's arrays. What only starts is forgotten before the loop begins.

import struct

from kitrobot_onboard import arrays, equip
from kitrobot_onboard import program as reading
from kitrobot_onboard.robot import run  # noqa: F401  main.py takes it from here
from kitrobot_onboard.state import BEGIN, FAULT, FORCED, HEARD, NAMES, NEWS, REST, SEEN, SENT, STATE, TOLD

LENGTH = 37  # of the list that a robot is: see `state`


def readied(port, package, program, generation):
    """A robot, and number, instruction and text of what kept its program from being ready, or None.

    `package` and `program` are names; `program` is None when there is none.
    """
    failed = None
    robot = [b"", [], [], [], [], [], 0, 0, 0, [], [], "", b""]
    try:
        if program:
            loaded = reading.load(program)
            text = equip.equip(port, loaded)
            if text:
                failed = 5, 65535, text
            else:
                robot = loaded[0]
    except MemoryError:
        failed = 3, 65535, ""
    except Exception as error:
        failed = 4, 65535, repr(error)
    while len(robot) < LENGTH:
        robot.append(0)
    robot[STATE] = robot[BEGIN] = 1 if robot[0] else 0
    robot[FAULT] = 0, 65535, 0, b""
    robot[FORCED] = {}
    robot[REST] = robot[SENT] = robot[NEWS] = robot[SEEN] = b""
    robot[HEARD] = robot[TOLD] = port.ticks()
    robot[NAMES] = struct.pack("<H", generation) + bytes(package + " " + (program[2:] if program else "-"), "utf8")
    return robot, failed


def forget():
    """Makes room: all this was needed once."""
    del reading.load, reading.is_whole, arrays.arrays, equip.equip
