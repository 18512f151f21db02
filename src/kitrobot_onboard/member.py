# A robot as a member of a team: it ticks when its host asks for it (docs/reference/link.md, `m`), with what the team
# told the host, and answers what has changed. Only what programs of teams bring along: it stays in memory, so that a
# tick needs nothing compiled.

import struct

from kitrobot_onboard.acting import stop
from kitrobot_onboard.checking import clamp
from kitrobot_onboard.state import (
    CELLS,
    COUNT,
    DATA,
    FAILED,
    FORCED,
    HELD,
    INPUTS,
    OUT,
    STATE,
    STEPS,
    THREADS,
    TOLD,
    TOLDTEAM,
    VISIBLE,
)


def take_order(robot):
    """Forces inputs and has a tick done; or, without a payload, stands still until the next one."""
    data = robot[DATA]
    if robot[STATE] != 2 or not robot[STEPS]:
        robot[TOLD] = 5
    elif not data:
        stop(robot)
        robot[STATE] = 2
        robot[TOLD] = 0
    elif len(data) % 5 != 1:
        robot[TOLD] = 3
    else:
        for at in range(1, len(data), 5):
            if not 0 < data[at] <= robot[INPUTS]:
                robot[TOLD] = 2
                return
            robot[CELLS][data[at]] = struct.unpack("<i", data[at + 1 : at + 5])[0]
            if data[at] not in robot[FORCED]:
                robot[FORCED].append(data[at])
        clamp(robot)
        if not robot[COUNT]:
            robot[TOLDTEAM] = [0] * (robot[VISIBLE] + len(robot[THREADS]) + len(robot[OUT]))
        robot[HELD] = True
        robot[STEPS] = 2


def tell_changes(robot):
    """The answer after that tick: the numbers that are others than those told last."""
    if robot[FAILED]:
        return 5
    data = b"M"
    at = 0
    for numbers in (robot[CELLS][: robot[VISIBLE]], robot[THREADS], robot[OUT]):
        for number in numbers:
            if robot[TOLDTEAM][at] != number:
                robot[TOLDTEAM][at] = number
                data += struct.pack("<Hi", at, number)
            at += 1
    return data
