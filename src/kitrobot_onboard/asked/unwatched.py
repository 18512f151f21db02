# A board that is too small to send news says so.

from kitrobot_onboard.state import DATA, TOLD

robot[TOLD] = 6
if robot[DATA] == b"\0\0":
    robot[TOLD] = 0
if len(robot[DATA]) != 2:
    robot[TOLD] = 3
