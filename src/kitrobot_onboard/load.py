# The last step to the loop: the program.

import struct

from kitrobot_onboard.arrays import HEADER, HEADER_SIZE, arrays
from kitrobot_onboard.state import CODE, FAILED, FIRST, INPUTS, PERIOD, STATE, VISIBLE

FORMAT = 1  # of images


def ready(port, line, robot):
    """Gives a robot the program of a file that `equip` found whole, and lets it run."""
    if line[2] == "-" or robot[FAILED]:
        return
    try:
        file = open(line[2], "rb")
        while len(file.readline()) > 1:
            pass
        fields = struct.unpack(HEADER, file.read(HEADER_SIZE))
        if fields[0] != b"KRI\0" or fields[1] != FORMAT:
            raise ValueError("another format")
        robot[: CODE + 5] = arrays(file.read, fields)
        file.close()
        robot[FIRST] = robot[1][: 1 + fields[6] + fields[7] + fields[8]]
        robot[INPUTS] = fields[6]
        robot[VISIBLE] = 1 + fields[6] + fields[7]
        robot[PERIOD] = fields[4]
        robot[STATE] = 2
    except MemoryError:
        robot[FAILED] = 3, 65535, ""
    except Exception as error:
        robot[FAILED] = 4, 65535, repr(error)
