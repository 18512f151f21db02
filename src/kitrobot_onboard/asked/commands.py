# What a tick on request gave.

import struct

from kitrobot_onboard.state import CELLS, COUNT, KINDS, OUT, PARS, STATE


def answer(port, robot, data):
    told = struct.pack("<IB", robot[COUNT], (1 if robot[CELLS][0] else 0) + (2 if robot[STATE] == 3 else 0))
    out = robot[OUT]
    for at in range(0, len(out), robot[PARS][3]):
        if out[at]:
            told += bytes((out[at + 2],))
            for k in range(robot[KINDS][out[at + 2]] // 2):
                told += struct.pack("<i", out[at + 3 + k])
    return "C", told
