# Hearing requests (docs/reference/link.md): the frames in what comes over the line.

from kitrobot_onboard.link import unwrap
from kitrobot_onboard.state import GONE, HEARD, LAST, READ, REPLY, REST, TICKS, TIDY, WRITE


def hear(robot, left):
    """Waits at most so many ms for what comes; the first request in it, as kind, number, payload; or None.

    One that was answered already is answered again, and that is all.
    """
    robot[TIDY]()
    data = robot[REST]
    at = data.find(b"~")
    if at < 0:
        robot[REST] = data = data[-60:] + robot[READ](left)
        robot[GONE] = b"\x03\x03" in data or b"\r\x03" in data
        return None
    robot[REST] = data[at + 1 :]
    found = unwrap(data[:at]) if 3 < at < 59 else None
    if found and found[0] >= "a" and found[1]:
        robot[HEARD] = robot[TICKS]()
        if robot[LAST] != found[:2] or found[0] in "hlp":
            return found
        robot[WRITE](robot[REPLY])
    return None
