# Clamps forced inputs to their ranges.

from kitrobot_onboard.state import KIND, TOLD

clamp(robot)
if robot[KIND] == "f":
    robot[TOLD] = 0
