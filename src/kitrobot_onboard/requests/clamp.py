# Clamps forced inputs to their ranges.

from kitrobot_onboard.state import ANSWER, KIND

clamp(robot)
if robot[KIND] == "f":
    robot[ANSWER] = 0
