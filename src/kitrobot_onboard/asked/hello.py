# Who it is and how it goes.

import gc
import struct

from kitrobot_onboard.state import COUNT, FAULT, LATE, NAMES, STATE


def answer(port, robot, data):
    if len(data) != 1:
        return 3
    fault = robot[FAULT][0] if robot[STATE] == 4 else 0
    gc.collect()
    free = gc.mem_free() if hasattr(gc, "mem_free") else 1 << 20
    told = struct.pack("<BBBIIH", 1, robot[STATE], fault, free, robot[COUNT], robot[LATE])
    return "H", told + robot[NAMES]
