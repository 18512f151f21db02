# A door that a servo moves. Where it is nobody knows; it is there after `time` from one end to the other.

import time

from kitrobot_onboard.drivers.any.shared.servos import door
from kitrobot_onboard.drivers.machine.pins import SERVO_HZ, Wave

SETTINGS = {"pin": "pin", "open": "0..180 = 90", "closed": "0..180 = 0", "time": "1..60000 = 1000"}
WAVES = {"pin": "50"}
PROCEDURES = "Open Close"


def make(settings):
    return door(settings, Wave(settings["pin"], SERVO_HZ), time)
