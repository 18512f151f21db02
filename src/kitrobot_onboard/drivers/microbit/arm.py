# An arm that a servo at a pin moves: to the box and back, half of `time` each way.

import utime

from kitrobot_onboard.drivers.any.shared.servos import Arm
from kitrobot_onboard.drivers.microbit.pins import Wave

SETTINGS = {
    "pin": "pin",
    "rest": "0..180 = 0",
    "load": "0..180 = 90",
    "unload": "0..180 = 90",
    "time": "100..60000 = 2000",
}
PROCEDURES = "Load Unload"


def make(settings):
    return Arm(settings, Wave(settings["pin"]), utime)
