# The frames of the link between a robot and a host: docs/reference/link.md. Both ends run this very code.
#
# A frame is "~", then type, sequence number, payload and a Fletcher-16 checksum, with five bytes escaped, then "~".
# What stands between frames is text (a traceback, what a program of one's own prints) or noise. The work on single
# bytes is left to methods of bytes: a small board has no time for loops.

PROTOCOL = 1
LONGEST = 60  # bytes a frame may have on its way to a robot, so that it fits the 64 of a small board's buffer

ESCAPED = b"}~\x03\x11\x13"  # each becomes "}" and itself with bit 5 turned; the first is the first to be escaped


def checksum(data):
    """Fletcher-16 of bytes: two sums modulo 255, the second in the high byte."""
    a = b = 0
    for x in data:
        a += x
        b += a
    return b % 255 << 8 | a % 255


def wrap(kind, number, payload):
    """The frame of a message: `kind` is one character, `number` 0...255."""
    data = bytes((ord(kind), number)) + payload  # the smallest board has no str.encode
    check = checksum(data)
    data += bytes((check & 255, check >> 8))
    for x in ESCAPED:
        data = data.replace(bytes((x,)), bytes((125, x ^ 32)))
    return b"~" + data + b"~"


def unwrap(data):
    """(kind, number, payload) of what stands between two "~", or None when that is no whole frame."""
    for x in reversed(ESCAPED):  # the smallest board slices with no step
        data = data.replace(bytes((125, x ^ 32)), bytes((x,)))
    end = len(data) - 2
    if end < 2 or data[0] > 127 or checksum(data[:end]) != data[end] | data[end + 1] << 8:
        return None
    return chr(data[0]), data[1], data[2:end]
