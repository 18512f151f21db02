# What needs a program is refused where there is none.

from kitrobot_onboard.state import CODE, FAULT, TOLD

if not robot[CODE]:
    robot[TOLD] = 1
if robot[FAULT][0] == 5:
    robot[TOLD] = 1
