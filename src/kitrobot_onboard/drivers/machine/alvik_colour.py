# The colour sensor of an Arduino Alvik, which looks at the ground (see `shared.alvik`): 1 red, 2 green, 3 blue, 0 for
# none of them. What it reads is set between black and white, as its maker measured them for each `revision` of the
# robot's board. A colour is seen when it is larger than both others by `margin` percent, and at least `dark` percent of
# white.

from kitrobot_onboard.drivers.machine.shared.alvik import COLOURS, robot

SETTINGS = {"revision": "1.3|1.6 = 1.3", "margin": "1..200 = 25", "dark": "0..100 = 10"}

BLACK = {"1.3": (160, 200, 190), "1.6": (385, 809, 411)}
WHITE = {"1.3": (450, 500, 510), "1.6": (726, 1478, 775)}


class Colour:
    def __init__(self, settings):
        self.robot = robot()
        revision = settings.get("revision", "1.3")
        self.ends = list(zip(BLACK[revision], WHITE[revision]))
        self.margin = 100 + int(settings.get("margin", "25"))
        self.dark = int(settings.get("dark", "10"))

    def read(self):
        raw = self.robot.numbers(COLOURS)
        if raw is None:
            return 0
        values = [
            max(0, min((one - black) * 100 // (white - black), 100)) for one, (black, white) in zip(raw, self.ends)
        ]
        most = max(values)
        if most < max(1, self.dark):
            return 0
        for other, value in enumerate(values):
            if other != values.index(most) and most * 100 < value * self.margin:
                return 0
        return values.index(most) + 1


make = Colour
