# The number of a section of a road, from a patch of colour on the ground under a colour sensor TCS34725: `red`, `green`
# and `blue` say the number that each of them stands for. One that is seen in `steady` readings one after the other
# counts, so that the edge of a patch does not; until the next one, and on a colour without a number, the number stays.

from kitrobot_onboard.drivers.machine.tcs34725 import Colour

SETTINGS = {
    "sda": "shared",
    "scl": "shared",
    "bus": "0..1 = 0",
    "margin": "1..200 = 25",
    "dark": "0..65535 = 30",
    "red": "0..1000?",
    "green": "0..1000?",
    "blue": "0..1000?",
    "steady": "1..50 = 2",
}


class Patches:
    def __init__(self, settings):
        names = ("red", "green", "blue")  # as the sensor numbers them, from 1 on
        self.numbers = {at + 1: int(settings[name]) for at, name in enumerate(names) if name in settings}
        if not self.numbers:
            raise ValueError("no colour has a number")
        self.sensor = Colour(settings)
        self.steady = int(settings.get("steady", "2"))
        self.number = int(settings.get("min", "0"))
        self.colour = 0
        self.times = 0

    def read(self):
        colour = self.sensor.read()
        self.times = self.times + 1 if colour == self.colour else 1
        self.colour = colour
        if self.times >= self.steady:
            self.times = self.steady
            self.number = self.numbers.get(colour, self.number)
        return self.number


make = Patches
