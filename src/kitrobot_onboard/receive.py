# Receives requests (docs/reference/link.md): the frames in the bytes that arrive over the line.

from kitrobot_onboard.link import unwrap
from kitrobot_onboard.state import GONE, HEARD, LAST, READ, REPLY, REST, TICKS, TIDY, WRITE


def receive_request(robot, left):
    """Reads for at most `left` ms; the first request, as kind, number, payload; or None.

    A repetition of the last request is answered again and not executed.
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
        if robot[LAST] != found[:2] or found[0] in "hlp":
            return found
        robot[WRITE](robot[REPLY])
        robot[HEARD] = robot[TICKS]()
    return None
