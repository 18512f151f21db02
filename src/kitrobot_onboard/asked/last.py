# The last fault.

import struct

from kitrobot_onboard.state import FAULT


def answer(port, robot, data):
    if data:
        return 3
    number, instruction, tick, text = robot[FAULT]
    return "F", struct.pack("<BHI", number, instruction, tick) + bytes(text, "utf8")
