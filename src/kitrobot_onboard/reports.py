# News of a running program (docs/reference/link.md, T): where its threads are, which cells changed, which instructions
# ran, its state, so that a host need not poll. Sent only in the gap before the next tick, and never more than fits it.

import struct

from kitrobot_onboard.link import wrap
from kitrobot_onboard.state import (
    CELLS,
    COUNT,
    DIFF,
    DUE,
    EVERY,
    LATE,
    NEWS,
    PARS,
    SEEN,
    SENT,
    SINCE,
    SPOT,
    STATE,
    STEPS,
    THREADS,
    TICKS,
    WRITE,
)

AT_ONCE = 6  # numbers that are looked at in one gap


def look(robot, room):
    """Looks at the next numbers, as long as there is room to report that they changed."""
    slots = robot[PARS][0]
    for spot in range(robot[SPOT], min(robot[SPOT] + AT_ONCE, len(robot[SENT]))):
        if len(robot[NEWS]) + 6 > room:
            break
        if spot < slots:
            value = robot[THREADS][2 * spot]
            value = 65535 if value < 0 else value - 1 if robot[THREADS][2 * spot + 1] else value
        else:
            value = robot[CELLS][spot - slots]
        if robot[SENT][spot] != value:
            robot[NEWS] += (
                bytes((116, spot)) + struct.pack("<H", value)
                if spot < slots
                else bytes((99, spot - slots)) + struct.pack("<i", value)
            )
            robot[SENT][spot] = value
        robot[SPOT] = spot + 1


def list_seen(robot, room):
    """The same with what ran."""
    while len(robot[NEWS]) + 3 <= room:
        at = bytes(robot[SEEN]).find(b"\1")
        if at < 0:
            break
        robot[SEEN][at] = 0
        robot[NEWS] += b"r" + struct.pack("<H", at)


def tell_news(robot, left):
    """Looks on for changes and reports them, as far as the `left` ms allow; returns how many are left."""
    since = robot[DIFF](robot[TICKS](), robot[SINCE])
    if since >= robot[EVERY] and not robot[WRITE](b""):  # else the line still has what was said before
        # As many bytes as fit the gap, of which 3 ms stay free: a byte takes 87 us, and a look at a number a third of
        # a millisecond. A robot that is late anyhow says a word now and then.
        room = 11 * min(left or since // 250, 8) - 49
        look(robot, room)
        end = robot[SPOT] == len(robot[SENT])
        if end:
            list_seen(robot, room)
        if len(robot[NEWS]) <= room and (end or len(robot[NEWS]) + 6 > room):
            if end:
                robot[SPOT] = 0
            robot[SINCE] = robot[TICKS]()
            if robot[NEWS] or end and robot[STATE] == 2:
                robot[NEWS] += bytes((115, robot[STATE])) + struct.pack("<H", min(robot[LATE], 65535))
                robot[WRITE](wrap("T", 0, struct.pack("<i", robot[COUNT]) + robot[NEWS]))
                robot[NEWS] = b""
        if robot[STATE] == 2 and not robot[STEPS]:
            left = max(robot[DIFF](robot[DUE], robot[TICKS]()), 0)
    return left
