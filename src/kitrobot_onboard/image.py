# The file of an image (.kri), and whether one is whole. `arrays` reads what is in it.
#
# The file, little-endian: "KRI\0", format, 0, robot fingerprint (8 bytes), tick and wait unit in ms, then the sizes:
# inputs, variables, counters, temporaries, constants, slots, parallels, stops, commands, actuators, most arguments
# (16 bits each), instructions (32 bits); then first values of the cells (32 bits each), slots (4 x 16 bits: parallel or
# 65535, entry, marked, end), parallels (3 x 16: parent slot, first slot, end), stops (2 x 16: slot, command), commands
# (16: actuator), the code (4 bytes an instruction), CRC-32 of all that.

import struct

from kitrobot_onboard.arrays import HEADER, HEADER_SIZE, arrays

FORMAT = 1


def crc32(data, end):
    """CRC-32 of data[0:end], bit by bit: slow and small, for boards that have no zlib."""
    crc = 0xFFFFFFFF
    for i in range(end):
        crc ^= data[i]
        for _ in range(8):
            crc = (crc >> 1) ^ (0xEDB88320 if crc & 1 else 0)
    return crc ^ 0xFFFFFFFF


def header(data):
    """The header's fields as a tuple. Raises ValueError with a sentence when the data is no image that we can read."""
    if len(data) < HEADER_SIZE + 4 or bytes(data[0:4]) != b"KRI\0":
        raise ValueError("this is not a KitRobot image")
    fields = struct.unpack(HEADER, bytes(data[0:HEADER_SIZE]))
    if fields[1] != FORMAT or fields[2] != 0:
        raise ValueError("this image has format %d, and only format %d can be read" % (fields[1], FORMAT))
    return fields


def body_size(fields):
    """Bytes between the header and the checksum."""
    cells = 1 + fields[6] + fields[7] + fields[8] + fields[9] + fields[10]
    return 4 * cells + 8 * fields[11] + 6 * fields[12] + 4 * fields[13] + 2 * fields[14] + 4 * fields[17]


def load(data):
    """The arrays code, cells, threads, pars, out of an image, ready for the first tick.

    Raises ValueError with a sentence when it is damaged. Does not verify it: a host did that before it sent it.
    """
    fields = header(data)
    size = HEADER_SIZE + body_size(fields)
    if len(data) != size + 4:
        raise ValueError("this image is damaged: %d bytes where %d belong" % (len(data), size + 4))
    if crc32(data, size) != struct.unpack("<I", bytes(data[size : size + 4]))[0]:
        raise ValueError("this image is damaged: its checksum does not fit")
    return whole_arrays(data, fields)


def whole_arrays(data, fields):
    """The arrays of an image whose header was read and whose length and checksum are right."""
    at = HEADER_SIZE

    def read(size):
        nonlocal at
        at += size
        return bytes(data[at - size : at])

    return arrays(read, fields)
