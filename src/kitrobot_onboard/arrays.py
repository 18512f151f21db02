# Reading an image into the arrays that `tick` works on, a few bytes at a time: the same code on a robot, where a file
# does not fit beside its arrays, and on a host. The layout of the file is in `image`, which says whether one is whole.

import struct

HEADER = "<4sHH8sHHHHHHHHHHHHHI"
HEADER_SIZE = 46
NO_PARALLEL = 65535


def arrays(read, fields):
    """The arrays code, cells, threads, pars, out, ready for the first tick.

    `read` gives the next bytes, as many as asked for, beginning behind the header, whose fields were checked before.
    """

    def half():
        return struct.unpack("<H", read(2))[0]

    slots = fields[11]
    parallels = fields[12]
    cells = []
    for _ in range(1 + fields[6] + fields[7] + fields[8] + fields[9] + fields[10]):
        cells.append(struct.unpack("<i", read(4))[0])
    width = 3 + fields[16]
    pars = [slots, parallels, fields[13], width]
    for _ in range(slots):
        parallel = half()
        pars.append(-1 if parallel == NO_PARALLEL else parallel)
        for _ in range(3):
            pars.append(half())
    for i in range(parallels):
        branches = 0
        unmarked = 0
        for k in range(4, 4 + 4 * slots, 4):
            if pars[k] == i:
                branches += 1
                if pars[k + 2] == 0:
                    unmarked += 1
        half()
        pars.append(0)
        pars.append(half())
        pars.append(half())
        pars.append(branches)
        pars.append(unmarked)
    for _ in range(fields[13]):
        pars.append(0)
        pars.append(half())
        pars.append(half())
    for _ in range(fields[14]):
        pars.append(width * half())
    threads = [-1, 0] * slots
    threads[0] = pars[5]
    return read(4 * fields[17]), cells, threads, pars, [0] * (width * fields[15])
