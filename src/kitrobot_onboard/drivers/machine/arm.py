# An arm that a servo moves: to the box and back, half of `time` each way.

import time

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


class Arm:
    def __init__(self, settings):
        self.wave = Wave(settings["pin"], SERVO_HZ)
        self.rest = int(settings.get("rest", "0"))
        self.reach = {"Load": int(settings.get("load", "90")), "Unload": int(settings.get("unload", "90"))}
        self.half = int(settings.get("time", "2000")) // 2
        self.begun = None
        self.returns = False

    def do(self, procedure, arguments):
        self.wave.angle(self.reach[procedure])
        self.begun = time.ticks_ms()
        self.returns = False

    def done(self):
        if self.begun is not None:
            gone = time.ticks_diff(time.ticks_ms(), self.begun)
            if not self.returns and gone >= self.half:
                self.wave.angle(self.rest)
                self.returns = True
            if gone >= 2 * self.half:
                self.begun = None
        return self.begun is None

    def stop(self):
        self.wave.give(0)  # without pulses a servo has no force
        self.begun = None


make = Arm
