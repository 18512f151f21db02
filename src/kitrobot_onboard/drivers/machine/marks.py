# The number of a section of a road, from a code of dark bars beside the line: one bar more than its number, each not
# wider than the ground between two. A code is over when no bar came for `gap` ms; until the next one the number stays.

import time

from machine import Pin

from kitrobot_onboard.drivers.machine.pins import pin

SETTINGS = {"pin": "input", "dark": "low|high = high", "gap": "40..5000 = 400"}


class Marks:
    def __init__(self, settings):
        self.pin = pin(settings["pin"], Pin.IN)
        self.dark = 0 if settings.get("dark") == "low" else 1
        self.gap = int(settings.get("gap", "400"))
        self.number = int(settings.get("min", "0"))
        self.bars = 0
        self.was = self.pin.value() == self.dark
        self.since = time.ticks_ms()

    def read(self):
        dark = self.pin.value() == self.dark
        if dark != self.was:
            self.was = dark
            self.since = time.ticks_ms()
            self.bars += dark
        elif self.bars and not dark and time.ticks_diff(time.ticks_ms(), self.since) >= self.gap:
            self.number = self.bars - 1
            self.bars = 0
        return self.number


make = Marks
