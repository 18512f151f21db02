# A colour sensor TCS34725 (ams) above the ground: 1 red, 2 green, 3 blue, 0 for none of them. A colour is seen when it
# is larger than both others by `margin` percent, and there is light at all.

from kitrobot_onboard.drivers.machine.shared.buses import bus_of

SETTINGS = {
    "sda": "shared",
    "scl": "shared",
    "bus": "0..1 = 0",
    "margin": "1..200 = 25",
    "dark": "0..65535 = 30",
}

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
    def __init__(self, settings):
        self.bus = bus_of(settings)
        self.margin = 100 + int(settings.get("margin", "25"))
        self.dark = int(settings.get("dark", "30"))
        for register, value in ((ENABLE, ON), (ATIME, MS_24), (CONTROL, GAIN_4)):
            self.bus.writeto_mem(ADDRESS, COMMAND | register, bytes((value,)))

    def read(self):
        data = self.bus.readfrom_mem(ADDRESS, COMMAND | IN_ROW | CLEAR, 8)
        values = [data[at] + 256 * data[at + 1] for at in (2, 4, 6)]
        if data[0] + 256 * data[1] < self.dark:
            return 0
        most = max(values)
        for other, value in enumerate(values):
            if other != values.index(most) and most * 100 < value * self.margin:
                return 0
        return values.index(most) + 1


make = Colour
