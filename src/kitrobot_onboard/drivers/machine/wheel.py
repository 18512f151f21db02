# One wheel of a robot with two motors (see `shared.bridges` for how they are wired). Where encoders are named, and both
# wheels are told the same speed, they are kept at one rate, as `drive` does.

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
    "side": "left|right",
}
WAVES = {
    "left-forward": "frequency !left-power !motors=pca9685",
    "left-backward": "frequency !left-power !bridge=direction !motors=pca9685",
    "left-power": "frequency !motors=pca9685",
    "right-forward": "frequency !right-power !motors=pca9685",
    "right-backward": "frequency !right-power !bridge=direction !motors=pca9685",
    "right-power": "frequency !motors=pca9685",
}
PROCEDURES = "Forward Backward Stop"


class Wheel:
    def __init__(self, settings):
        self.base = base_of(settings)
        self.side = 0 if settings["side"] == "left" else 1
        self.straight = None
        if "counts" in settings:
            from kitrobot_onboard.drivers.machine.shared.encoders import straight_of

            self.straight = straight_of(settings)

    def do(self, procedure, arguments):
        speed = 0
        if procedure == "Forward":
            speed = arguments[0]
        elif procedure == "Backward":
            speed = -arguments[0]
        if self.straight and speed != self.base.wheels[self.side]:
            self.straight.begin()  # one wheel was ahead rightly
        self.base.wheels[self.side] = speed
        self.move()

    def tend(self):
        """Is called at each tick."""
        if self.straight:
            self.move()

    def move(self):
        left, right = self.base.wheels
        if self.straight and left == right and left:
            if self.base.is_alone("wheels"):
                left, right = self.straight.speeds(left)
            else:
                self.straight.begin()
        self.base.want("wheels", left, right)

    def stop(self):
        self.base.stop()


make = Wheel
