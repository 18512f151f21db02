# Holds an input at a value, or lets it go.

import struct

from kitrobot_onboard.state import FORCED, INPUTS


def answer(port, robot, data):
    if len(data) != 6:
        return 3
    cell, on, value = struct.unpack("<BBi", data)
    if not 0 < cell <= robot[INPUTS]:
        return 2
    robot[FORCED][cell] = value
    if not on:
        del robot[FORCED][cell]
    return 0
