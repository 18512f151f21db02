# A robot as a member of a team: it ticks when its host asks for it (docs/reference/link.md, `m`), with what the team
# sent to the host, and answers with what has changed. Only programs of teams bring it along: it stays in memory, so
# that a tick needs nothing compiled.

import struct

from kitrobot_onboard.actuation import stop
from kitrobot_onboard.request_checks import clamp
from kitrobot_onboard.state import (
    ANSWER,
    CELLS,
    COUNT,
    DATA,
    FAILED,
    FORCED,
    HELD,
    INPUTS,
    OUT,
    SENTTEAM,
    STATE,
    STEPS,
    THREADS,
    VISIBLE,
)


def take_order(robot):
    """Forces inputs and has a tick done; or, without a payload, stands still until the next one."""
    data = robot[DATA]
    if robot[STATE] != 2 or not robot[STEPS]:
        robot[ANSWER] = 5
    elif not data:
        stop(robot)
        robot[STATE] = 2
        robot[ANSWER] = 0
    elif len(data) % 5 != 1:
        robot[ANSWER] = 3
    else:
        for at in range(1, len(data), 5):
            if not 0 < data[at] <= robot[INPUTS]:
                robot[ANSWER] = 2
                return
            robot[CELLS][data[at]] = struct.unpack("<i", data[at + 1 : at + 5])[0]
            if data[at] not in robot[FORCED]:
                robot[FORCED].append(data[at])
        clamp(robot)
        if not robot[COUNT]:
            robot[SENTTEAM] = [0] * (robot[VISIBLE] + len(robot[THREADS]) + len(robot[OUT]))
        robot[HELD] = True
        robot[STEPS] = 2


def tell_changes(robot):
    """The answer after that tick: the numbers that differ from those sent last."""
    if robot[FAILED]:
        return 5
    data = b"M"
    at = 0
    for numbers in (robot[CELLS][: robot[VISIBLE]], robot[THREADS], robot[OUT]):
        for number in numbers:
            if robot[SENTTEAM][at] != number:
                robot[SENTTEAM][at] = number
                data += struct.pack("<Hi", at, number)
            at += 1
    return data
