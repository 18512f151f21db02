# An ultrasonic range finder such as HC-SR04 (see `shared.echoes`). The sensor's least value is touching, its largest is
# `reach` or more.

from kitrobot_onboard.drivers.machine.shared.echoes import MM, SCALE, Finder

SETTINGS = {"trigger": "shared", "echo": "shared", "reach": "20..4000 = 1000"}


class Range:
    def __init__(self, settings):
        self.reach = int(settings.get("reach", "1000"))
        self.least = int(settings.get("min", "0"))
        self.most = int(settings.get("max", "100"))
        self.finder = Finder(settings["trigger"], settings["echo"], self.reach)

    def read(self):
        width = self.finder.look()
        if width is None:
            return self.most
        span = self.most - self.least
        return min(self.most, self.least + (width * MM * span + self.reach * SCALE // 2) // (self.reach * SCALE))


make = Range
