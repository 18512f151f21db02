# Makes the robot visible, until no frame arrives for a while. `identify` is the port's.

from kitrobot_onboard.state import DIFF, HEARD, SHOWN, TELL, TICKS, TOLD

SHOW_MS = 2000


def hide(robot, left):
    if robot[DIFF](robot[TICKS](), robot[HEARD]) > SHOW_MS:
        identify(False)
        robot[SHOWN] = False
        robot[TELL].remove(hide)
    return left


if not robot[SHOWN]:
    identify(True)
    robot[SHOWN] = True
    robot[TELL].append(hide)
robot[TOLD] = 0
