# One wheel of a robot with two motors (see `shared.bridges` for how they are wired).

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
        self.side = settings["side"]

    def do(self, procedure, arguments):
        speed = 0
        if procedure == "Forward":
            speed = arguments[0]
        elif procedure == "Backward":
            speed = -arguments[0]
        if self.side == "left":
            self.base.want("left", speed, 0)
        else:
            self.base.want("right", 0, speed)

    def stop(self):
        self.base.stop()


make = Wheel
