# A robot that drives straight on with two motors (see `shared.bridges` for how they are wired). Where
# encoders are named it keeps both wheels at one rate, from tick to tick.

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
    "counts": "20..100000?",
    "left-count": "input?",
    "right-count": "input?",
    "straight": "0..20 = 3",
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


class Drive:
    def __init__(self, settings):
        self.base = base_of(settings)
        self.speed = 0
        self.straight = None
        if "counts" in settings:
            from kitrobot_onboard.drivers.machine.shared.encoders import Straight

            self.straight = Straight(settings)

    def do(self, procedure, arguments):
        speed = 0
        if procedure == "Advance":
            speed = arguments[0]
        elif procedure == "Reverse":
            speed = -arguments[0]
        if self.straight and speed * self.speed <= 0:  # told again on the way, it keeps its direction
            self.straight.begin()
        self.speed = speed
        if self.straight and speed:
            self.tend()
        else:
            self.base.want("drive", speed, speed)

    def tend(self):
        """Is called at each tick."""
        if self.straight and self.speed:
            if self.base.is_alone("drive"):
                self.base.want("drive", *self.straight.speeds(self.speed))
            else:  # it turns, so one wheel is ahead rightly
                self.straight.begin()
                self.base.want("drive", self.speed, self.speed)

    def stop(self):
        self.speed = 0
        self.base.stop()


make = Drive
