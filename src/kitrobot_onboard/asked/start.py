# Back to the program's first instruction; every device was stopped before. 2 is for a tick on request.

from kitrobot_onboard.state import CELLS, COUNT, DUE, FAULT, FIRST, HELD, LATE, PARS, STATE, STEPS, THREADS


def answer(port, robot, data):
    if len(data) != 1 or data[0] > 2:
        return 3
    pars = robot[PARS]
    robot[CELLS][: len(robot[FIRST])] = robot[FIRST]
    robot[THREADS][:] = [-1, 0] * pars[0]
    robot[THREADS][0] = pars[5]
    at = 4 + 4 * pars[0]
    for _ in range(pars[1]):
        pars[at] = 0
        at += 5
    for _ in range(pars[2]):
        pars[at] = 0
        at += 3
    robot[FAULT] = 0, 65535, 0, ""
    robot[COUNT] = robot[LATE] = 0
    robot[STATE] = 2
    robot[STEPS] = data[0] == 2
    robot[HELD] = data[0] == 1
    robot[DUE] = port.ticks()
    return 0
