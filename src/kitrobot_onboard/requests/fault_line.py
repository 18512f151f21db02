# What the last fault says, behind the line of a user's own driver in which it came up
# (`kitrobot.deploy.package.package`).

import io
import sys

from kitrobot_onboard.state import FAULT

text = ""
if isinstance(robot[FAULT][3], Exception) and hasattr(sys, "print_exception"):
    device = io.StringIO()
    sys.print_exception(robot[FAULT][3], device)
    for at in device.getvalue().split("\n"):
        if '.driver.py", line ' in at:
            text = at.split(", ")[1] + " "
text += repr(robot[FAULT][3])
