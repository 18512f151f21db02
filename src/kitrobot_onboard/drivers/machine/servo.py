# A door that a servo moves. Where it is nobody knows; it is there after `time` from one end to the other.

import time

from kitrobot_onboard.drivers.machine.pins import SERVO_HZ, Wave

SETTINGS = {"pin": "pin", "open": "0..180 = 90", "closed": "0..180 = 0", "time": "1..60000 = 1000"}
WAVES = {"pin": "50"}
PROCEDURES = "Open Close"


class Servo:
    """Goes to the angle of a procedure; one that has none changes nothing."""

    def __init__(self, pin, angles, needed):
        self.wave = Wave(pin, SERVO_HZ)
        self.angles = angles
        self.needed = needed
        self.begun = None

    def do(self, procedure, arguments):
        if procedure in self.angles:
            self.wave.angle(self.angles[procedure])
            self.begun = time.ticks_ms()

    def done(self):
        return self.begun is None or time.ticks_diff(time.ticks_ms(), self.begun) >= self.needed

    def stop(self):
        self.wave.give(0)  # without pulses a servo has no force
        self.begun = None


def make(settings):
    angles = {"Open": int(settings.get("open", "90")), "Close": int(settings.get("closed", "0"))}
    return Servo(settings["pin"], angles, int(settings.get("time", "1000")))
