# A robot that turns on the spot with two motors (see `shared.bridges` for how they are wired), counter-clockwise. How
# far it has turned it knows from a gyroscope, from the encoders of its wheels, or else from the clock: `rate` is how
# fast it turns at full speed, in degrees a second. `counts`: how often both encoders together change while it turns
# once around. A gyroscope is on the same bus as a chip for the motors.

import time

from kitrobot_onboard.drivers.machine.shared.motors import base_of

SETTINGS = {
    "motors": "pins|pca9685 = pins",
    "motors-address": "64..119 = 64 where motors=pca9685",
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
    "rate": "10..2000 = 180",
    "counts": "20..100000?",
    "left-count": "input?",
    "right-count": "input?",
    "gyro": "lsm6dso|none = none",
    "sda": "shared where motors=pca9685; shared?",
    "scl": "shared where motors=pca9685; shared?",
    "bus": "0..1 = 0",
    "address": "8..119 = 107",
}
WAVES = {
    "left-forward": "frequency !left-power !motors=pca9685",
    "left-backward": "frequency !left-power !bridge=direction !motors=pca9685",
    "left-power": "frequency !motors=pca9685",
    "right-forward": "frequency !right-power !motors=pca9685",
    "right-backward": "frequency !right-power !bridge=direction !motors=pca9685",
    "right-power": "frequency !motors=pca9685",
}
PROCEDURES = "AbsoluteTurn Turn LeftBy RightBy Stop"


class Clock:
    """By the clock: in thousandths of a degree, at full speed."""

    def __init__(self, settings):
        self.rate = int(settings.get("rate", "180"))
        self.speed = 0
        self.since = time.ticks_ms()

    def begin(self, speed):
        self.speed = speed
        self.since = time.ticks_ms()

    def turned(self):
        return time.ticks_diff(time.ticks_ms(), self.since) * self.rate * self.speed // 100


class Turn:
    def __init__(self, settings):
        self.base = base_of(settings)
        if settings.get("gyro", "none") == "lsm6dso":
            from kitrobot_onboard.drivers.machine.shared.gyro import Gyro

            self.measure = Gyro(settings)
        elif "counts" in settings:
            from kitrobot_onboard.drivers.machine.shared.encoders import Encoders

            self.measure = Encoders(settings)
        else:
            self.measure = Clock(settings)
        self.goal = None

    def do(self, procedure, arguments):
        self.goal = None
        if procedure == "Stop":
            self.base.want("turn", 0, 0)
        else:
            speed = arguments[-1]
            if procedure == "AbsoluteTurn":
                self.goal = arguments[0] * 3600  # from percent of a full turn
            elif procedure in ("LeftBy", "RightBy"):
                self.goal = abs(speed) * 1000
                speed = 50 if (speed > 0) == (procedure == "LeftBy") else -50
            if self.goal is not None:
                self.measure.begin(speed)
            self.base.want("turn", -speed, speed)

    def done(self):
        if self.goal is not None and abs(self.measure.turned()) >= self.goal:
            self.goal = None
            self.base.want("turn", 0, 0)
        return self.goal is None

    def stop(self):
        self.goal = None
        self.base.stop()


make = Turn
