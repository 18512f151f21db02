# News of a running program (docs/reference/link.md, T): where its threads stand, which cells changed, which
# instructions ran. Only in the gap before the next tick, a little at a time, and never more than fits it.

import struct

from kitrobot_onboard.link import wrap
from kitrobot_onboard.state import CELLS, COUNT, EVERY, NEWS, PARS, SEEN, SENT, SPOT, TELL, THREADS, TOLD


def tell(port, robot, left):
    """Goes on with looking for what changed, and tells it, as far as the `left` ms allow."""
    since = port.diff(port.ticks(), robot[TOLD])
    if since < robot[EVERY]:
        return
    # As many bytes as fit the gap, of which 3 ms stay free: a byte takes 87 us, and a look at a number a third of a
    # millisecond. A robot that is late anyhow says a word now and then.
    room = 11 * min(left or since // 250, 8) - 47
    sent = robot[SENT]
    slots = robot[PARS][0]
    spot = robot[SPOT]
    news = robot[NEWS]
    end = min(spot + 6, len(sent))
    while spot < end and len(news) + 6 <= room:
        if spot < slots:
            value = robot[THREADS][2 * spot]
            value = 65535 if value < 0 else value - 1 if robot[THREADS][2 * spot + 1] else value
        else:
            value = robot[CELLS][spot - slots]
        if sent[spot] != value:
            news += (
                struct.pack("<BBH", 116, spot, value) if spot < slots else struct.pack("<BBi", 99, spot - slots, value)
            )
            sent[spot] = value
        spot += 1
    while spot == len(sent) and len(news) + 3 <= room:
        at = bytes(robot[SEEN]).find(b"\1")
        if at < 0:
            break
        robot[SEEN][at] = 0
        news += struct.pack("<BH", 114, at)
    if len(news) <= room and (spot == len(sent) or len(news) + 6 > room):
        if spot == len(sent):
            spot = 0
        robot[TOLD] = port.ticks()
        if news:
            port.write(wrap("T", 0, struct.pack("<I", robot[COUNT]) + news))
            news = b""
    robot[SPOT] = spot
    robot[NEWS] = news


def answer(port, robot, data):
    """What `w` asks after it has made the lists: from now on the loop calls `tell`."""
    if robot[SENT]:
        robot[TELL] = tell
        robot[EVERY] = struct.unpack("<H", data)[0]
    return 0
