# The second step to the loop: whether the program file (docs/reference/link.md) is whole.

from kitrobot_onboard.state import FAILED


def ready(port, line, robot):
    """Says in FAILED when the file of the program is damaged or cannot be read."""
    if line[2] == "-":
        return
    try:
        file = open(line[2], "rb")
        first = file.readline()
        a = b = 0
        while True:
            data = file.read(32)
            if not data:
                break
            for x in data:
                a += x
                b += a
            a %= 255
            b %= 255
        file.close()
        if first.split() != [b"KRP1", b"%d" % (b << 8 | a)]:
            robot[FAILED] = 4, 65535, "damaged"
    except MemoryError:
        robot[FAILED] = 3, 65535, ""
    except Exception as error:
        robot[FAILED] = 4, 65535, repr(error)
