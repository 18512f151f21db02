# What the last fault says.

from kitrobot_onboard.state import FAULT

text = repr(robot[FAULT][3])
