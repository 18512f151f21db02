# A colour sensor TCS34725 (ams) above the ground, at the I2C bus of the edge, pins 19 and 20. A colour is seen when it
# is larger than both others by `margin` percent, and there is light at all.
#
# `tcs34725` gives it as 1 red, 2 green, 3 blue, 0 for none of them; `patches` as the number of a section of a road. All
# of it is in one function: on the micro:bit of 2016 the stack ends in one that calls another.

from microbit import i2c

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
    def __init__(self, settings, patches):
        self.margin = 100 + int(settings.get("margin", "25"))
        self.dark = int(settings.get("dark", "30"))
        self.steady = int(settings.get("steady", "2"))
        self.number = int(settings.get("min", "0"))
        self.colour = self.times = 0
        self.numbers = {}
        for colour, name in ((1, "red"), (2, "green"), (3, "blue")):
            if name in settings:
                self.numbers[colour] = int(settings[name])
        if patches and not self.numbers:
            raise ValueError("no colour has a number")
        for register, value in ((ENABLE, ON), (ATIME, MS_24), (CONTROL, GAIN_4)):
            i2c.write(ADDRESS, bytes((COMMAND | register, value)))

    def read(self):
        i2c.write(ADDRESS, bytes((COMMAND | IN_ROW | CLEAR,)), True)  # the bus is kept
        data = i2c.read(ADDRESS, 8)
        values = [data[2] + 256 * data[3], data[4] + 256 * data[5], data[6] + 256 * data[7]]
        ranked = sorted(values)
        colour = values.index(ranked[2]) + 1
        if data[0] + 256 * data[1] < self.dark or ranked[2] * 100 < ranked[1] * self.margin:
            colour = 0
        if not self.numbers:
            return colour
        self.times = self.times + 1 if colour == self.colour else 1
        self.colour = colour
        if self.times >= self.steady:
            self.times = self.steady
            self.number = self.numbers.get(colour, self.number)
        return self.number
