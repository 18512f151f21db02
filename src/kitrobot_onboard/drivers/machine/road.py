# A robot on a road, which is a dark line: two sensors look at the ground to the left and to the right of it, and the
# wheel on the side that sees it goes slower, at each tick. Two motors (see `shared.motors` for their pins).

from kitrobot_onboard.drivers.machine.line import Line
from kitrobot_onboard.drivers.machine.shared.motors import base_of

SETTINGS = {
    "left-forward": "shared",
    "left-backward": "shared",
    "left-power": "shared?",
    "right-forward": "shared",
    "right-backward": "shared",
    "right-power": "shared?",
    "bridge": "inputs|direction = inputs",
    "frequency": "10..100000 = 1000",
    "least": "0..90 = 0",
    "left-flipped": "yes|no = no",
    "right-flipped": "yes|no = no",
    "left-trim": "10..100 = 100",
    "right-trim": "10..100 = 100",
    "left-eye": "input",
    "right-eye": "input",
    "threshold": "1..65535?",
    "dark": "low|high = high",
    "steer": "1..100 = 60",
}
WAVES = {
    "left-forward": "frequency !left-power",
    "left-backward": "frequency !left-power !bridge=direction",
    "left-power": "frequency",
    "right-forward": "frequency !right-power",
    "right-backward": "frequency !right-power !bridge=direction",
    "right-power": "frequency",
}
PROCEDURES = "Advance Reverse Stop"


class Road:
    def __init__(self, settings):
        self.base = base_of(settings)
        self.steer = int(settings.get("steer", "60"))
        dark = settings.get("dark", "high")
        threshold = settings.get("threshold", "0")
        eyes = ("left-eye", "right-eye")
        self.eyes = [Line({"pin": settings[name], "dark": dark, "threshold": threshold}) for name in eyes]
        self.speed = 0

    def do(self, procedure, arguments):
        self.speed = 0
        if procedure == "Advance":
            self.speed = arguments[0]
        elif procedure == "Reverse":
            self.speed = -arguments[0]
        self.tend()

    def tend(self):
        """Is called at each tick."""
        speeds = [self.speed, self.speed]
        if self.speed > 0:  # backward it cannot see where it goes
            for side in (0, 1):
                if self.eyes[side].read():
                    speeds[side] -= self.speed * self.steer // 100
        self.base.want("drive", speeds[0], speeds[1])

    def stop(self):
        self.speed = 0
        self.base.stop()


make = Road
