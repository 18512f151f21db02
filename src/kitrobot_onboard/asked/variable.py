# Sets a variable.

import struct

from kitrobot_onboard.state import CELLS, INPUTS, VISIBLE


def answer(port, robot, data):
    if len(data) != 5:
        return 3
    cell, value = struct.unpack("<Bi", data)
    if not robot[INPUTS] < cell < robot[VISIBLE]:
        return 2
    robot[CELLS][cell] = value
    return 0
