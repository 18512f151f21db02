# What a robot hears over its link, and what it answers: docs/reference/link.md says what each request means.

import struct

from kitrobot_onboard.link import PROTOCOL, unwrap, wrap
from kitrobot_onboard.state import (
    BEGIN,
    CELLS,
    CODE,
    COUNT,
    EVERY,
    FAULT,
    FORCED,
    GONE,
    HALT,
    HEARD,
    INPUTS,
    LAST,
    LATE,
    NAMES,
    NEWS,
    PARS,
    REPLY,
    REST,
    SEEN,
    SENT,
    SHOWN,
    SPOT,
    STATE,
    STEPS,
    VISIBLE,
    WANT,
)

SHOW_MS = 2000


def hear(port, robot, left):
    """Waits at most so many ms for what comes, and answers the first whole request in it."""
    data = robot[REST]
    at = data.find(b"~")
    if at < 0:
        robot[REST] = data = data[-60:] + port.read(left)
        if b"\x03\x03" in data or b"\r\x03" in data:
            robot[GONE] = robot[HALT] = True
        elif robot[SHOWN] and port.diff(port.ticks(), robot[HEARD]) > SHOW_MS:
            robot[SHOWN] = False
            port.identify(False)
        return
    robot[REST] = data[at + 1 :]
    found = unwrap(data[:at]) if 3 < at < 59 else None
    if not found or found[0] < "a" or not found[1]:
        return
    robot[HEARD] = port.ticks()
    kind, number, data = found
    if robot[LAST] == found[:2] and kind not in "hlp":
        port.write(robot[REPLY])
        return
    robot[LAST] = None
    fault = robot[FAULT]
    sort = "K"
    told = b""
    why = 0
    try:
        if kind == "h":
            sort = "H"
            at = fault[0] if robot[STATE] == 4 else 0
            told = (
                struct.pack("<BBBIIH", PROTOCOL, robot[STATE], at, port.free(), robot[COUNT], robot[LATE])
                + robot[NAMES]
            )
        elif kind == "l":
            sort = "F"
            told = struct.pack("<BHI", *fault[:3]) + fault[3]
        elif kind == "x" or kind == "q":
            robot[HALT] = True
            robot[GONE] = kind == "q"
        elif kind == "i":
            if not robot[SHOWN]:
                port.identify(True)
            robot[SHOWN] = True
        elif kind == "p":
            pass
        elif kind not in "snfvw":
            why = 4
        elif not robot[CODE]:
            why = 6 if fault[0] == 3 else 1
        elif kind == "s":
            robot[BEGIN] = data[0] + 1
            robot[HALT] = True
            robot[STEPS] = False
        elif kind == "w":
            robot[EVERY] = struct.unpack("<H", data)[0]
            robot[SEEN] = robot[SENT] = robot[NEWS] = b""
            robot[SPOT] = 0
            if robot[EVERY]:
                robot[SENT] = [None] * (robot[PARS][0] + robot[VISIBLE])
                robot[SEEN] = bytearray(len(robot[CODE]) // 4)
        elif kind == "v":
            at, value = struct.unpack("<Bi", data)
            if robot[INPUTS] < at < robot[VISIBLE]:
                robot[CELLS][at] = value
            else:
                why = 2
        else:
            on = True
            if kind == "f":
                on = data[1]
                data = data[:1] + data[2:]
            if len(data) % 5:
                raise ValueError
            for n in range(0, len(data), 5):
                at, value = struct.unpack("<Bi", data[n : n + 5])
                if not 0 < at <= robot[INPUTS]:
                    why = 2
                elif on:
                    robot[FORCED][at] = value
                elif at in robot[FORCED]:
                    del robot[FORCED][at]
            if kind == "n" and not why:
                robot[STEPS] = True
                robot[WANT] = number
                if robot[STATE] != 2:
                    robot[HALT] = robot[BEGIN] = True
                robot[LAST] = found[:2]
                return
    except MemoryError:
        raise
    except Exception:
        why = 3
    if why:
        sort = "N"
        told = bytes((why,))
    robot[REPLY] = wrap(sort, number, told)
    port.write(robot[REPLY])
    robot[LAST] = found[:2]
