# Keeps inputs that are held within what they can be.

from kitrobot_onboard.state import KIND, TOLD

clamp(robot)
if robot[KIND] == "f":
    robot[TOLD] = 0
