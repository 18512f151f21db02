# One wheel of a kit of a micro:bit (see `drive`).

from kitrobot_onboard.drivers.microbit.shared.base import begin, halt, move, wanted

SETTINGS = {"kit": "maqueen|cutebot|move", "side": "left|right"}
PROCEDURES = "Forward Backward Stop"


class Wheel:
    def __init__(self, settings):
        self.kit = settings["kit"]
        self.at = 3 if settings["side"] == "right" else 2
        begin(self.kit)

    def do(self, procedure, arguments):
        wanted[self.at] = 0
        if procedure == "Forward":
            wanted[self.at] = arguments[0]
        elif procedure == "Backward":
            wanted[self.at] = -arguments[0]
        move(self.kit)

    def stop(self):
        halt(self.kit)


make = Wheel
