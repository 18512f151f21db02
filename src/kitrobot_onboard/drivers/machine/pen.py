# A pen that a servo lifts and puts down, each within `time`. It has one colour and one width, whatever a program says.

import time

from kitrobot_onboard.drivers.machine.pins import SERVO_HZ, Wave

SETTINGS = {"pin": "pin", "down": "0..180 = 90", "up": "0..180 = 0", "time": "1..60000 = 300"}
PROCEDURES = "PenDown PenUp Colour Width"


class Pen:
    def __init__(self, settings):
        self.wave = Wave(settings["pin"], SERVO_HZ)
        self.angles = {"PenDown": int(settings.get("down", "90")), "PenUp": int(settings.get("up", "0"))}
        self.needed = int(settings.get("time", "300"))
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


make = Pen
