# Hearing requests (docs/reference/link.md): the frames in what comes over the line.

from kitrobot_onboard.link import unwrap
from kitrobot_onboard.state import GONE, HEARD, LAST, REPLY, REST, SHOWN

SHOW_MS = 2000


def hear(port, robot, left):
    """Waits at most so many ms for what comes; the first request in it, as kind, number, payload; or None.

    One that was answered already is answered again, and that is all.
    """
    data = robot[REST]
    at = data.find(b"~")
    if at < 0:
        robot[REST] = data = data[-60:] + port.read(left)
        if b"\x03\x03" in data or b"\r\x03" in data:
            robot[GONE] = True
        elif robot[SHOWN] and port.diff(port.ticks(), robot[HEARD]) > SHOW_MS:
            return "i", 0, b"\0"
        return None
    robot[REST] = data[at + 1 :]
    found = unwrap(data[:at]) if 3 < at < 59 else None
    if not found or found[0] < "a" or not found[1]:
        return None
    robot[HEARD] = port.ticks()
    if robot[LAST] == found[:2] and found[0] not in "hlp":
        port.write(robot[REPLY])
        return None
    return found


def asked(port, kind):
    """The source of what is asked less often, out of the file where each stands behind its letter and its size."""
    file = open(port.ASKED)
    text = "def answer(port, robot, data): return 4"
    while True:
        words = file.readline().split()
        if not words:
            break
        found = file.read(int(words[1]))
        if words[0] == kind:
            text = found
            break
    file.close()
    return text
