# A sensor that looks at the ground and gives a voltage: its least value on bright ground, one more on a dark line.

import microbit

SETTINGS = {"pin": "input", "threshold": "1..1023 = 512", "dark": "low|high = high"}


class Line:
    def __init__(self, settings):
        self.pin = getattr(microbit, "pin" + settings["pin"])
        self.least = int(settings.get("min", "0"))
        self.threshold = int(settings.get("threshold", "512"))
        self.dark = settings.get("dark", "high") == "high"

    def read(self):
        return self.least + ((self.pin.read_analog() >= self.threshold) == self.dark)


make = Line
