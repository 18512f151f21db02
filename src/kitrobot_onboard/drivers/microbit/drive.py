# A kit of a micro:bit that drives straight on: Maqueen (DFRobot), Cutebot (ELECFREAKS), :MOVE Motor (Kitronik).

from kitrobot_onboard.drivers.microbit.shared.motors import Motors

SETTINGS = {"kit": "maqueen|cutebot|move"}
PROCEDURES = "Advance Reverse Stop"


def make(settings):
    return Motors(settings, 0)
