# Checks that several requests share (see `requests`).

from kitrobot_onboard.state import ACTUATORS, ANSWER, CELLS, CODE, FAULT, SENSORS


def need_program(robot):
    """Refuses a request where there is no program."""
    if not robot[CODE] or robot[FAULT][0] == 5:
        robot[ANSWER] = 1


def clamp(robot):
    """Keeps inputs that are held within what they can be."""
    for part in robot[SENSORS]:
        robot[CELLS][part[1]] = max(part[2], min(part[3], robot[CELLS][part[1]]))
    for part in robot[ACTUATORS]:
        if part[1] and robot[CELLS][part[1]]:
            robot[CELLS][part[1]] = 1
