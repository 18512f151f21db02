# The number of a section of a road, from a code of dark bars beside the line: one bar more than its number, each not
# wider than the ground between two. A code is over when no bar came for `gap` ms; until the next one the number stays.
# All of it is here: on the micro:bit of 2016 the stack ends in a driver that brings helpers along.

import microbit

SETTINGS = {"pin": "input", "dark": "low|high = high", "gap": "40..5000 = 400"}


class Marks:
    def __init__(self, settings):
        self.pin = getattr(microbit, "pin" + settings["pin"])
        self.dark = 0 if settings.get("dark") == "low" else 1
        self.gap = int(settings.get("gap", "400"))
        self.number = int(settings.get("min", "0"))
        self.bars = 0
        self.was = self.pin.read_digital() == self.dark
        self.since = microbit.running_time()

    def read(self):
        dark = self.pin.read_digital() == self.dark
        now = microbit.running_time()
        if dark != self.was:
            self.was = dark
            self.since = now
            self.bars += dark
        elif self.bars and not dark and now - self.since >= self.gap:
            self.number = self.bars - 1
            self.bars = 0
        return self.number


make = Marks
