# A kit of a micro:bit that drives straight on: Maqueen (DFRobot), Cutebot (ELECFREAKS), :MOVE Motor (Kitronik).

from kitrobot_onboard.drivers.microbit.shared.base import begin, halt, move, wanted

SETTINGS = {"kit": "maqueen|cutebot|move"}
PROCEDURES = "Advance Reverse Stop"


class Drive:
    def __init__(self, settings):
        self.kit = settings["kit"]
        begin(self.kit)

    def do(self, procedure, arguments):
        wanted[0] = 0
        if procedure == "Advance":
            wanted[0] = arguments[0]
        elif procedure == "Reverse":
            wanted[0] = -arguments[0]
        move(self.kit)

    def stop(self):
        halt(self.kit)


make = Drive
