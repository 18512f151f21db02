# A colour sensor TCS34725 (ams) above the ground: 1 red, 2 green, 3 blue, 0 for none of them. A colour is seen when it
# is larger than both others by `margin` percent, and there is light at all. `tell(register, value)` and
# `ask(register, count)` reach it.

ADDRESS = 0x29
COMMAND = 0x80
IN_ROW = 0x20  # counts the register up while it is read
ENABLE = 0x00
ATIME = 0x01
CONTROL = 0x0F
CLEAR = 0x14
ON = 0x03
MS_24 = 0xF6
GAIN_4 = 0x01


class Colour:
    def __init__(self, settings, tell, ask):
        self.ask = ask
        self.margin = 100 + int(settings.get("margin", "25"))
        self.dark = int(settings.get("dark", "30"))
        for register, value in ((ENABLE, ON), (ATIME, MS_24), (CONTROL, GAIN_4)):
            tell(COMMAND | register, value)

    def read(self):
        data = self.ask(COMMAND | IN_ROW | CLEAR, 8)
        values = [data[at] + 256 * data[at + 1] for at in (2, 4, 6)]
        if data[0] + 256 * data[1] < self.dark:
            return 0
        most = max(values)
        for other, value in enumerate(values):
            if other != values.index(most) and most * 100 < value * self.margin:
                return 0
        return values.index(most) + 1


class Patches:
    """The number of a section of a road, from a patch of colour under the sensor: `red`, `green` and `blue` say the
    number that each of them stands for. One that is seen in `steady` readings one after the other counts, so that the
    edge of a patch does not; until the next one, and on a colour without a number, the number stays. `sensor` makes a
    Colour of the settings.
    """

    def __init__(self, settings, sensor):
        names = ("red", "green", "blue")  # as the sensor numbers them, from 1 on
        self.numbers = {at + 1: int(settings[name]) for at, name in enumerate(names) if name in settings}
        if not self.numbers:
            raise ValueError("no colour has a number")
        self.sensor = sensor(settings)
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
