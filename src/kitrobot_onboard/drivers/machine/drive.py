# A robot that drives straight on with two motors (see `shared.bridges` for how they are wired). Where
# encoders are named it keeps both wheels at one rate, from tick to tick. A distance it drives by the clock, at half
# speed: `speed` is how fast it is at full speed, in millimetres a second.

import time

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
    "speed": "10..5000 = 400",
}
WAVES = {
    "left-forward": "frequency !left-power !motors=pca9685",
    "left-backward": "frequency !left-power !bridge=direction !motors=pca9685",
    "left-power": "frequency !motors=pca9685",
    "right-forward": "frequency !right-power !motors=pca9685",
    "right-backward": "frequency !right-power !bridge=direction !motors=pca9685",
    "right-power": "frequency !motors=pca9685",
}
PROCEDURES = "Advance Reverse DriveBy BackBy Stop"


class Drive:
    def __init__(self, settings):
        self.base = base_of(settings)
        self.full = int(settings.get("speed", "400"))
        self.speed = 0
        self.needed = None  # milliseconds that a distance takes
        self.straight = None
        if "counts" in settings:
            from kitrobot_onboard.drivers.machine.shared.encoders import Straight

            self.straight = Straight(settings)

    def do(self, procedure, arguments):
        speed = 0
        self.needed = None
        if procedure == "Advance":
            speed = arguments[0]
        elif procedure == "Reverse":
            speed = -arguments[0]
        elif procedure in ("DriveBy", "BackBy"):
            distance = arguments[0] if procedure == "DriveBy" else -arguments[0]
            speed = 50 if distance > 0 else -50
            self.needed = abs(distance) * 20000 // self.full
            self.since = time.ticks_ms()
        if self.straight and speed * self.speed <= 0:  # told again on the way, it keeps its direction
            self.straight.begin()
        self.speed = speed
        if self.straight and speed:
            self.tend()
        else:
            self.base.want("drive", speed, speed)

    def done(self):
        if self.needed is not None and time.ticks_diff(time.ticks_ms(), self.since) >= self.needed:
            self.do("Stop", ())
        return self.needed is None

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
        self.needed = None
        self.base.stop()


make = Drive
