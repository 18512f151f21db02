# One of the three eyes of an Arduino Alvik that look at the ground (see `shared.alvik`): its least value on bright
# ground, one more on a dark line, where it reads `threshold` or more.

from kitrobot_onboard.drivers.machine.shared.alvik import LINES, robot

SETTINGS = {"eye": "left|center|right", "threshold": "1..1023 = 512"}
NAMES = ("left", "center", "right")


class Line:
    def __init__(self, settings):
        self.robot = robot()
        self.eye = NAMES.index(settings["eye"])
        self.threshold = int(settings.get("threshold", "512"))
        self.least = int(settings.get("min", "0"))

    def read(self):
        eyes = self.robot.numbers(LINES)
        return self.least + (1 if eyes and eyes[self.eye] >= self.threshold else 0)


make = Line
