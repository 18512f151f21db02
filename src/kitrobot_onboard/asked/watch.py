# Begins or ends the news.

import gc
import struct

from kitrobot_onboard.state import CODE, EVERY, NEWS, PARS, SEEN, SENT, SPOT, TELL, VISIBLE


def answer(port, robot, data):
    if len(data) != 2:
        return 3
    robot[SEEN] = robot[SENT] = robot[NEWS] = b""
    robot[SPOT] = robot[EVERY] = robot[TELL] = 0
    every = struct.unpack("<H", data)[0]
    if every:
        robot[SENT] = [-2] * (robot[PARS][0] + robot[VISIBLE])
        size = len(robot[CODE]) // 4
        gc.collect()
        if not hasattr(gc, "mem_free") or gc.mem_free() > size + 400:  # what ran is told where there is room for it
            robot[SEEN] = bytearray(size)
    return 0
