# What a tick on request needs before and after it.

from kitrobot_onboard.state import KIND, STATE

robot[KIND] = "C" if robot[STATE] == 2 else "sC"
