# Reading an image (a .kri file) into the arrays that `tick` works on. The same code reads it on a robot and on a host.
#
# The file, little-endian: "KRI\0", format, 0, robot fingerprint (8 bytes), tick and wait unit in ms, then the sizes:
# inputs, variables, counters, temporaries, constants, slots, parallels, stops, commands, actuators, most arguments
# (16 bits each), instructions (32 bits); then first values of the cells (32 bits each), slots (4 x 16 bits: parallel or
# 65535, entry, marked, end), parallels (3 x 16: parent slot, first slot, end), stops (2 x 16: slot, command), commands
# (16: actuator), the code (4 bytes an instruction), CRC-32 of all that.

try:
    import struct
except ImportError:
    import ustruct as struct

FORMAT = 1
HEADER = "<4sHH8sHHHHHHHHHHHHHI"
HEADER_SIZE = 46
NO_PARALLEL = 65535


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
    return arrays(data, fields)


def arrays(data, fields):
    """The arrays of an image whose header was read and whose length and checksum are right."""
    slots = fields[11]
    parallels = fields[12]
    stops = fields[13]
    commands = fields[14]
    count = 1 + fields[6] + fields[7] + fields[8] + fields[9] + fields[10]
    at = HEADER_SIZE
    cells = list(struct.unpack("<%di" % count, bytes(data[at : at + 4 * count])))
    at += 4 * count
    table = struct.unpack("<%dH" % (4 * slots), bytes(data[at : at + 8 * slots]))
    at += 8 * slots
    joins = struct.unpack("<%dH" % (3 * parallels), bytes(data[at : at + 6 * parallels]))
    at += 6 * parallels
    ends = struct.unpack("<%dH" % (2 * stops), bytes(data[at : at + 4 * stops]))
    at += 4 * stops
    parts = struct.unpack("<%dH" % commands, bytes(data[at : at + 2 * commands]))
    at += 2 * commands
    width = 3 + fields[16]
    pars = [slots, parallels, stops, width]
    for i in range(0, 4 * slots, 4):
        pars.append(-1 if table[i] == NO_PARALLEL else table[i])
        pars.append(table[i + 1])
        pars.append(table[i + 2])
        pars.append(table[i + 3])
    for i in range(parallels):
        branches = 0
        unmarked = 0
        for k in range(0, 4 * slots, 4):
            if table[k] == i:
                branches += 1
                if table[k + 2] == 0:
                    unmarked += 1
        pars.append(0)
        pars.append(joins[3 * i + 1])
        pars.append(joins[3 * i + 2])
        pars.append(branches)
        pars.append(unmarked)
    for i in range(0, 2 * stops, 2):
        pars.append(0)
        pars.append(ends[i])
        pars.append(ends[i + 1])
    for part in parts:
        pars.append(width * part)
    threads = [-1, 0] * slots
    threads[0] = table[1]
    return bytes(data[at : at + 4 * fields[17]]), cells, threads, pars, [0] * (width * fields[15])
