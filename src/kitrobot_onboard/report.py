# News of a running program: which cells changed, where its threads stand, which instructions ran. Only in the gap
# before the next tick, a little at a time, and never so long that the next tick would be late.

import struct

from kitrobot_onboard.link import wrap

MOST = 44  # bytes of records in a message
FRAME = 14  # bytes that a message has besides, and some escapes
SPARE_MS = 3  # as long may a look at one number take, and what is left over
LATE_MS = 2000  # a robot whose ticks are late anyhow still says something every so often


def tell(robot):
    """Goes on with looking for what changed, as far as there is time; sends it when that is due."""
    port = robot.port
    sent = robot.sent
    since = port.diff(port.ticks(), robot.told)
    if since < robot.period or not sent:
        return
    timed = robot.state == 2 and not robot.steps
    room = MOST
    if timed:
        left = port.diff(robot.due, port.ticks())
        if left <= 0 and since > LATE_MS:
            timed = False
        else:
            room = min(MOST, (left - SPARE_MS) * 1000 // (port.BYTE_US + 1) - FRAME)
    slots = robot.pars[0]
    n = robot.next
    while n < len(sent) and len(robot.news) + 6 <= room:
        if timed and port.diff(robot.due, port.ticks()) <= SPARE_MS:
            break
        if n < slots:
            at = robot.threads[2 * n]
            at = 65535 if at < 0 else at - 1 if robot.threads[2 * n + 1] else at
            if sent[n] != at:
                robot.news += struct.pack("<BBH", 116, n, at)
        else:
            at = robot.cells[n - slots]
            if sent[n] != at:
                robot.news += struct.pack("<BBi", 99, n - slots, at)
        sent[n] = at
        n += 1
    robot.next = n
    while n == len(sent) and len(robot.news) + 3 <= room:
        at = bytes(robot.seen).find(b"\1")
        if at < 0:
            break
        robot.seen[at] = 0
        robot.news += struct.pack("<BH", 114, at)
    if len(robot.news) > room or n < len(sent) and len(robot.news) + 6 <= room:
        return
    if timed and port.diff(robot.due, port.ticks()) * 1000 < (len(robot.news) + FRAME) * port.BYTE_US:
        return
    if n == len(sent):
        robot.next = 0
    robot.told = port.ticks()
    if robot.news:
        port.write(wrap("T", 0, struct.pack("<I", robot.ticks) + robot.news))
        robot.news = b""
