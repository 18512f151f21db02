# A new number at each tick, from the sensor's least value to its largest.

from random import randint

SETTINGS = {}


class Chance:
    def __init__(self, settings):
        self.range = int(settings.get("min", "0")), int(settings.get("max", "100"))

    def read(self):
        return randint(self.range[0], self.range[1])


make = Chance
