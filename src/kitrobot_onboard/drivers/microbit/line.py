# A sensor that looks at the ground: its least value on bright ground, one more on a dark line.

import microbit

SETTINGS = {"pin": "input", "dark": "low|high = high"}


class Line:
    def __init__(self, settings):
        self.pin = getattr(microbit, "pin" + settings["pin"])
        self.least = int(settings.get("min", "0"))
        self.dark = 0 if settings.get("dark") == "low" else 1

    def read(self):
        return self.least + (self.pin.read_digital() == self.dark)


make = Line
