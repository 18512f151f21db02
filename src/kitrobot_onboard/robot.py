# The loop of a robot: in each tick sample the inputs, run the program, hand its commands to the devices; in the gap
# until the next one tell what changed and listen to the link (docs/reference/link.md). Whatever a driver does wrong
# stops the devices, never the link.
#
# The smallest board has 9 kB for everything, and a stack for five calls in one another. So `run` is one function,
# with much in local variables, which are by far the smallest; what others must know too is in a list (see `state`). A
# request only says what is to happen, and each round does it in this order: stop, tell of a fault, begin, react, tell,
# hear.

import struct

from kitrobot_onboard.interpreter import tick
from kitrobot_onboard.link import wrap
from kitrobot_onboard.report import tell
from kitrobot_onboard.requests import hear
from kitrobot_onboard.state import (
    ACTUATORS,
    BEGIN,
    CELLS,
    CODE,
    COUNT,
    DUE,
    EVERY,
    FAULT,
    FIRST,
    FORCED,
    GONE,
    HALT,
    HEARD,
    HELD,
    KINDS,
    LATE,
    OUT,
    PARS,
    PERIOD,
    PROCEDURES,
    REPLY,
    SEEN,
    SENSORS,
    STATE,
    STEPS,
    THREADS,
    WANT,
)

GAP_MS = 50  # the longest wait when no tick is due
HOLD_MS = 800  # a held run ends when no whole frame came for so long


def run(port, robot, failed):
    """Goes on until somebody asks for the prompt.

    `failed`: number, instruction and text of a fault that kept the program from being ready, or None.
    """
    ticks = port.ticks
    diff = port.diff
    pack = struct.pack
    cells = robot[CELLS]
    threads = robot[THREADS]
    pars = robot[PARS]
    out = robot[OUT]
    forced = robot[FORCED]
    actuators = robot[ACTUATORS]
    while True:
        n = None  # the device in hand: the number of an actuator, -1 - that of a sensor
        instruction = 65535
        left = GAP_MS
        try:
            if robot[HALT] or failed:
                robot[HALT] = robot[HELD] = False
                n = 0
                for part in actuators:
                    if part:
                        part[3] = None
                        try:
                            part[0].stop()
                        except Exception as error:
                            failed = failed or (1, 65535, "a%d %r" % (n, error))
                    n += 1
                robot[STATE] = min(robot[STATE], 1)
                if robot[GONE]:
                    return
            if failed:
                robot[FAULT] = failed[0], failed[1], robot[COUNT], bytes(failed[2][:60], "utf8")
                failed = None
                robot[BEGIN] = 0
                robot[STATE] = 4
                if robot[WANT]:
                    robot[REPLY] = wrap("N", robot[WANT], b"\5")
                    port.write(robot[REPLY])
                    robot[WANT] = 0
                port.write(wrap("F", 0, pack("<BHI", *robot[FAULT][:3]) + robot[FAULT][3]))
            if robot[BEGIN]:
                n = 0
                for value in robot[FIRST]:
                    cells[n] = value
                    n += 1
                for n in range(len(threads)):
                    threads[n] = n % 2 - 1
                threads[0] = pars[5]
                at = 4 + 4 * pars[0]
                for n in range(pars[1]):
                    pars[at] = 0
                    at += 5
                for n in range(pars[2]):
                    pars[at] = 0
                    at += 3
                robot[FAULT] = 0, 65535, 0, b""
                robot[COUNT] = robot[LATE] = 0
                robot[STATE] = 2
                robot[DUE] = ticks()
                robot[HELD] = robot[BEGIN] == 2
                robot[BEGIN] = 0
            if robot[STATE] == 2 and not robot[STEPS]:
                left = diff(robot[DUE], ticks())
                if robot[HELD] and diff(ticks(), robot[HEARD]) > HOLD_MS:
                    failed = 6, 65535, ""
                    continue
            if robot[WANT] or left <= 0:
                n = 0
                for read, at, least, most in robot[SENSORS]:
                    n -= 1
                    value = forced[at] if at in forced else read()
                    cells[at] = least if value < least else most if value > most else value
                n = 0
                for part in actuators:
                    if part:
                        at = part[1]
                        if part[3] is not None:
                            instruction = part[4]
                            if part[0].done():
                                part[3] = None
                            elif not robot[STEPS] and diff(ticks(), part[3]) > part[2]:
                                failed = 2, instruction, "a%d not done" % n
                        if at:
                            cells[at] = (1 if forced[at] else 0) if at in forced else 1 if part[3] is None else 0
                    n += 1
                if failed:
                    continue
                n = None
                instruction = 65535
                tick(robot[CODE], cells, threads, pars, out, robot[SEEN])
                robot[COUNT] += 1
                if threads[0] < 0:
                    robot[STATE] = 3
                told = pack("<IB", robot[COUNT], (1 if cells[0] else 0) + (2 if threads[0] < 0 else 0))
                n = at = 0
                for part in actuators:
                    if out[at]:
                        instruction = part[4] = out[at + 1]
                        kind = robot[KINDS][out[at + 2]]
                        value = out[at + 3 : at + 3 + kind // 2]
                        part[3] = ticks() if kind % 2 else None
                        part[0].do(robot[PROCEDURES].split(",")[out[at + 2]], value)
                        if robot[WANT]:
                            told += bytes((out[at + 2],)) + pack("<%di" % len(value), *value)
                    at += pars[3]
                    n += 1
                if robot[WANT]:
                    robot[REPLY] = wrap("C", robot[WANT], told)
                    port.write(robot[REPLY])
                    robot[WANT] = 0
                else:
                    robot[DUE] = port.add(robot[DUE], robot[PERIOD])
                    if diff(robot[DUE], ticks()) < 0:
                        robot[DUE] = ticks()
                        robot[LATE] = min(robot[LATE] + 1, 65535)
                left = max(diff(robot[DUE], ticks()), 0)
            if robot[EVERY]:
                tell(port, robot, left)
                if left < GAP_MS:
                    left = max(diff(robot[DUE], ticks()), 0)
            hear(port, robot, left)
        except MemoryError:
            failed = 3, instruction, ""
        except KeyboardInterrupt:
            robot[GONE] = robot[HALT] = True
        except Exception as error:
            failed = 1, instruction, ("" if n is None else "a%d " % n if n >= 0 else "s%d " % (-1 - n)) + repr(error)
