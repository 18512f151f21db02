# Holds inputs at values, before a tick on request.

import struct

from kitrobot_onboard.state import FORCED, INPUTS


def answer(port, robot, data):
    if len(data) % 5:
        return 3
    for at in range(0, len(data), 5):
        if not 0 < data[at] <= robot[INPUTS]:
            return 2
    for at in range(0, len(data), 5):
        robot[FORCED][data[at]] = struct.unpack("<i", data[at + 1 : at + 5])[0]
    return 0
