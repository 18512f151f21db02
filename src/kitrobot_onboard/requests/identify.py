# Makes the robot visible, until no frame arrives for a while. `identify` is the port's.

from kitrobot_onboard.state import ANSWER, DIFF, HEARD, REPORTS, SHOWN, TICKS

SHOW_MS = 2000


def hide(robot, left):
    if robot[DIFF](robot[TICKS](), robot[HEARD]) > SHOW_MS:
        identify(False)
        robot[SHOWN] = False
        robot[REPORTS].remove(hide)
    return left


if not robot[SHOWN]:
    identify(True)
    robot[SHOWN] = True
    robot[REPORTS].append(hide)
robot[ANSWER] = 0
