# A pen that a servo lifts and puts down, each within `time`. It has one colour and one width, whatever a program says.

import time

from kitrobot_onboard.drivers.any.shared.servos import Servo
from kitrobot_onboard.drivers.machine.pins import SERVO_HZ, Wave

SETTINGS = {"pin": "pin", "down": "0..180 = 90", "up": "0..180 = 0", "time": "1..60000 = 300"}
WAVES = {"pin": "50"}
PROCEDURES = "PenDown PenUp Colour Width"


def make(settings):
    angles = {"PenDown": int(settings.get("down", "90")), "PenUp": int(settings.get("up", "0"))}
    return Servo(Wave(settings["pin"], SERVO_HZ), angles, int(settings.get("time", "300")), time)
