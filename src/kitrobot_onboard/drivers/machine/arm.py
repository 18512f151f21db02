# An arm that a servo moves: to the box and back, half of `time` each way.

import time

from kitrobot_onboard.drivers.any.shared.servos import Arm
from kitrobot_onboard.drivers.machine.pins import SERVO_HZ, Wave

SETTINGS = {
    "pin": "pin",
    "rest": "0..180 = 0",
    "load": "0..180 = 90",
    "unload": "0..180 = 90",
    "time": "100..60000 = 2000",
}
WAVES = {"pin": "50"}
PROCEDURES = "Load Unload"


def make(settings):
    return Arm(settings, Wave(settings["pin"], SERVO_HZ), time)
