# One wheel of a robot with two motors (see `shared.motors` for their pins).

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
    "side": "left|right",
}
WAVES = {
    "left-forward": "frequency !left-power",
    "left-backward": "frequency !left-power !bridge=direction",
    "left-power": "frequency",
    "right-forward": "frequency !right-power",
    "right-backward": "frequency !right-power !bridge=direction",
    "right-power": "frequency",
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
