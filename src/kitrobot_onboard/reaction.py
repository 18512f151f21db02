# One tick of a robot, with the inputs before and the commands after it.

from kitrobot_onboard.actuation import fail
from kitrobot_onboard.interpreter import tick
from kitrobot_onboard.state import (
    ACTUATORS,
    CELLS,
    COUNT,
    DIFF,
    FORCED,
    KINDS,
    OUT,
    PARS,
    PROCEDURES,
    SENSORS,
    STATE,
    STEPS,
    THREADS,
    TICKS,
    WHO,
)


def react(robot):
    """One tick. An error is recorded in FAILED."""
    number = 1
    try:
        cells = robot[CELLS]
        for part in robot[SENSORS]:
            robot[WHO] = part
            if part[1] not in robot[FORCED]:
                cells[part[1]] = max(part[2], min(part[3], part[0]()))
        for part in robot[ACTUATORS]:
            robot[WHO] = part
            if part[3] is not None:
                if part[8]():
                    part[3] = None
                elif not robot[STEPS] and robot[DIFF](robot[TICKS](), part[3]) > part[2]:
                    number = 2
                    raise ValueError
            if part[1] and part[1] not in robot[FORCED]:
                cells[part[1]] = 1 if part[3] is None else 0
        robot[WHO] = None
        tick(*robot[:6])
        robot[COUNT] += 1
        if robot[THREADS][0] < 0:
            robot[STATE] = 3
        cells = robot[OUT]
        for part in robot[ACTUATORS]:
            at = part[5] * robot[PARS][3]
            if cells[at]:
                robot[WHO] = part
                part[4] = cells[at + 1]
                at += 2
                kind = robot[KINDS][cells[at]]
                part[3] = robot[TICKS]() if kind % 2 else None
                part[7](robot[PROCEDURES][cells[at]], cells[at + 1 : at + 1 + kind // 2])
        robot[WHO] = None
    except Exception as error:
        fail(robot, number, error)
