# A buzzer at a pin: a tone, for a time or until Stop.

import time

from kitrobot_onboard.drivers.machine.pins import FULL, Wave

SETTINGS = {"pin": "pin", "loudness": "1..100 = 50"}
WAVES = {"pin": "0"}
PROCEDURES = "Tone Stop"


class Buzzer:
    def __init__(self, settings):
        self.wave = Wave(settings["pin"], 440)
        self.part = int(settings.get("loudness", "50")) * FULL // 200
        self.until = None

    def do(self, procedure, arguments):
        self.stop()
        if procedure == "Tone":
            self.wave.pwm.freq(arguments[0])
            self.wave.give(self.part)
            if len(arguments) > 1:
                self.until = time.ticks_add(time.ticks_ms(), arguments[1])

    def done(self):
        if self.until is not None and time.ticks_diff(self.until, time.ticks_ms()) <= 0:
            self.stop()
        return self.until is None

    def stop(self):
        self.wave.give(0)
        self.until = None


make = Buzzer
