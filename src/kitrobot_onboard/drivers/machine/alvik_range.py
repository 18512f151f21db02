# The range finder of an Arduino Alvik (see `shared.alvik`): one of its zones. The sensor's least value is touching, its
# largest is `reach` or more, or nothing seen yet.

from kitrobot_onboard.drivers.machine.shared.alvik import ZONES, robot

SETTINGS = {
    "reach": "20..4000 = 1000",
    "zone": "left|center-left|center|center-right|right|top|bottom = center",
}
NAMES = ("left", "center-left", "center", "center-right", "right", "top", "bottom")


class Range:
    def __init__(self, settings):
        self.robot = robot()
        self.zone = NAMES.index(settings.get("zone", "center"))
        self.reach = int(settings.get("reach", "1000"))
        self.least = int(settings.get("min", "0"))
        self.most = int(settings.get("max", "100"))

    def read(self):
        zones = self.robot.numbers(ZONES)
        if zones is None:
            return self.most
        span = self.most - self.least
        return min(self.most, self.least + (max(0, zones[self.zone]) * span + self.reach // 2) // self.reach)


make = Range
