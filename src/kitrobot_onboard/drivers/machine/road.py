# A robot on a road, which is a dark line: two sensors look at the ground to the left and to the right of it, and the
# wheel on the side that sees it goes slower, at each tick. Two motors (see `shared.bridges` for how they are wired).
# `eyes`: what they are, as of the drivers `line` and `qtr-line`.

from kitrobot_onboard.drivers.machine.line import Line
from kitrobot_onboard.drivers.machine.shared.motors import base_of

SETTINGS = {
    "motors": "pins|pca9685 = pins",
    "motors-address": "64..119 = 64 where motors=pca9685",
    "sda": "shared where motors=pca9685",
    "scl": "shared where motors=pca9685",
    "bus": "0..1 = 0 where motors=pca9685",
    "left-forward": "channel 0..15 where motors=pca9685; shared",
    "left-backward": "channel 0..15 where motors=pca9685; shared",
    "left-power": "channel 0..15? where motors=pca9685; shared?",
    "right-forward": "channel 0..15 where motors=pca9685; shared",
    "right-backward": "channel 0..15 where motors=pca9685; shared",
    "right-power": "channel 0..15? where motors=pca9685; shared?",
    "bridge": "inputs|direction = inputs",
    "frequency": "24..1526 = 1000 where motors=pca9685; 10..100000 = 1000",
    "least": "0..90 = 0",
    "left-flipped": "yes|no = no",
    "right-flipped": "yes|no = no",
    "left-trim": "10..100 = 100",
    "right-trim": "10..100 = 100",
    "left-eye": "input",
    "right-eye": "input",
    "eyes": "line|qtr = line",
    "emitter": "shared where eyes=qtr",
    "threshold": "50..1000 = 512 where eyes=qtr; 1..65535?",
    "dark": "low|high = high",
    "steer": "1..100 = 60",
}
WAVES = {
    "left-forward": "frequency !left-power !motors=pca9685",
    "left-backward": "frequency !left-power !bridge=direction !motors=pca9685",
    "left-power": "frequency !motors=pca9685",
    "right-forward": "frequency !right-power !motors=pca9685",
    "right-backward": "frequency !right-power !bridge=direction !motors=pca9685",
    "right-power": "frequency !motors=pca9685",
}
PROCEDURES = "Advance Reverse Stop"


class Road:
    def __init__(self, settings):
        self.base = base_of(settings)
        self.steer = int(settings.get("steer", "60"))
        make_eye = Line
        if settings.get("eyes", "line") == "qtr":
            from kitrobot_onboard.drivers.machine.qtr_line import Line as make_eye
        names = ("emitter", "threshold", "dark")
        told = {name: settings[name] for name in names if name in settings}
        self.eyes = [make_eye(dict(told, pin=settings[name])) for name in ("left-eye", "right-eye")]
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
