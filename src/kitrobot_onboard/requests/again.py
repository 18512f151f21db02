# Before and after a tick on request.

from kitrobot_onboard.state import KIND, STATE

robot[KIND] = "C" if robot[STATE] == 2 else "sC"
