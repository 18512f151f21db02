# A robot on a road, which is a dark line: two sensors look at the ground to the left and to the right of it, and the
# wheel on the side that sees it goes slower, at each tick. Two motors (see `shared.motors` for their pins).

from machine import Pin

from kitrobot_onboard.drivers.machine.pins import pin
from kitrobot_onboard.drivers.machine.shared.motors import base_of

SETTINGS = {
    "left-forward": "shared?",
    "left-backward": "shared?",
    "left-power": "shared?",
    "left-turned": "shared?",
    "right-forward": "shared?",
    "right-backward": "shared?",
    "right-power": "shared?",
    "right-turned": "shared?",
    "frequency": "10..100000 = 1000",
    "least": "0..90 = 0",
    "left-flipped": "yes|no = no",
    "right-flipped": "yes|no = no",
    "left-trim": "10..100 = 100",
    "right-trim": "10..100 = 100",
    "left-eye": "input",
    "right-eye": "input",
    "dark": "low|high = high",
    "steer": "1..100 = 60",
}
PROCEDURES = "Advance Reverse Stop"


class Road:
    def __init__(self, settings):
        self.base = base_of(settings)
        self.dark = 0 if settings.get("dark") == "low" else 1
        self.steer = int(settings.get("steer", "60"))
        self.eyes = [pin(settings[name], Pin.IN) for name in ("left-eye", "right-eye")]
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
                if self.eyes[side].value() == self.dark:
                    speeds[side] -= self.speed * self.steer // 100
        self.base.want("drive", speeds[0], speeds[1])

    def stop(self):
        self.speed = 0
        self.base.stop()


make = Road
