# Ends the trial of what was installed last (see `krboot`).

import os

from kitrobot_onboard.state import ANSWER

if "krt" in os.listdir():
    os.remove("krt")
robot[ANSWER] = 0
