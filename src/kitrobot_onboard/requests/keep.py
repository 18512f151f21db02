# Ends the trial of what was installed last (see `krboot`).

import os

from kitrobot_onboard.state import TOLD

if "krt" in os.listdir():
    os.remove("krt")
robot[TOLD] = 0
