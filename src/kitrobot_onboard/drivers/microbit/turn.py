# A kit of a micro:bit that turns on the spot, counter-clockwise, by the clock: at full speed `rate` degrees a second.

from kitrobot_onboard.drivers.microbit.shared.motors import Motors

SETTINGS = {"kit": "maqueen|cutebot|move", "rate": "10..2000 = 180"}
PROCEDURES = "AbsoluteTurn Turn Stop"


def make(settings):
    return Motors(settings, 1)
