# What a robot does with a request and answers to it: docs/reference/link.md says what each means.

import struct

from kitrobot_onboard.link import PROTOCOL, wrap

KINDS = "hsxnfvwpilq"
SIZES = b"\1\1\0\0\6\5\2\0\0\0\0"  # of their payloads; `n` has as many parts of 5 as it likes


def answer(robot, kind, data, number):
    """Does what a request says; the frame of the answer."""
    at = KINDS.find(kind)
    if at < 0:
        why = 4
    elif len(data) % 5 if kind == "n" else len(data) != SIZES[at]:
        why = 3
    elif kind in "nfv" and robot.cells is None:
        why = 1
    else:
        try:
            why = obey(robot, kind, data)
        except MemoryError:
            robot.fail(3, 65535, "")
            why = 6
    if why == 0:
        return wrap("K", number, b"")
    if isinstance(why, int):
        return wrap("N", number, bytes((why,)))
    return wrap(why[0], number, why[1])


def obey(robot, kind, data):
    """0 for done, a number that says why not, or kind and payload of another answer."""
    fault = robot.fault
    if kind == "h":
        ours = struct.pack(
            "<BBBIIHH", PROTOCOL, robot.state, fault[0], robot.port.free(), robot.ticks, robot.late, robot.generation
        )
        return "H", ours + bytes(robot.names, "utf8")
    if kind == "l":
        return "F", struct.pack("<BHI", fault[0], fault[1], fault[2]) + bytes(fault[3], "utf8")
    if kind == "n":
        return step(robot, data)
    if kind == "s":
        if not robot.begin(False):
            return 6 if fault[0] == 3 else 1
        robot.held = data[0] == 1
    elif kind == "x":
        failed = robot.stop()
        if failed:
            robot.fail(1, 65535, failed)
    elif kind == "f":
        cell, on, value = struct.unpack("<BBi", data)
        if not 0 < cell <= robot.inputs:
            return 2
        if on:
            robot.forced[cell] = value
        elif cell in robot.forced:
            del robot.forced[cell]
    elif kind == "v":
        cell, value = struct.unpack("<Bi", data)
        if not robot.inputs < cell < robot.visible:
            return 2
        robot.cells[cell] = value
    elif kind == "w":
        robot.period = struct.unpack("<H", data)[0]
        robot.seen = robot.sent = ()
        if robot.period and robot.cells is not None:
            robot.seen = bytearray(len(robot.code) // 4)
            robot.sent = [None] * (robot.pars[0] + robot.visible)
        robot.next = 0
        robot.news = b""
    elif kind == "i":
        if robot.shown is None:
            robot.port.identify(True)
        robot.shown = robot.port.ticks()
    elif kind == "q":
        robot.stop()
        robot.gone = True
    return 0


def step(robot, data):
    """One tick with inputs forced; the commands it gave."""
    for i in range(0, len(data), 5):
        if not 0 < data[i] <= robot.inputs:
            return 2
    for i in range(0, len(data), 5):
        robot.forced[data[i]] = struct.unpack("<i", data[i + 1 : i + 5])[0]
    if robot.state != 2:
        robot.begin(True)
    robot.steps = True
    robot.held = False
    robot.react()
    if robot.state == 4:
        return 5
    told = struct.pack("<IB", robot.ticks, (robot.cells[0] & 1) | (2 if robot.state == 3 else 0))
    out = robot.out
    for o in range(0, len(out), robot.pars[3]):
        if out[o]:
            told += bytes((out[o + 2],))
            for k in range(o + 3, o + 3 + (robot.kinds[out[o + 2]] >> 1)):
                told += struct.pack("<i", out[k])
    return "C", told
