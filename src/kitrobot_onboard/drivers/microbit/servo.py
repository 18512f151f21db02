# A door that a servo at a pin moves; it is there after `time` from one end to the other.

import utime

from kitrobot_onboard.drivers.any.shared.servos import door
from kitrobot_onboard.drivers.microbit.pins import Wave

SETTINGS = {"pin": "pin", "open": "0..180 = 90", "closed": "0..180 = 0", "time": "1..60000 = 1000"}
PROCEDURES = "Open Close"


def make(settings):
    return door(settings, Wave(settings["pin"]), utime)
