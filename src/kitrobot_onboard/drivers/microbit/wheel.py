# One wheel of a kit of a micro:bit (see `drive`).

from kitrobot_onboard.drivers.microbit.shared.motors import Motors

SETTINGS = {"kit": "maqueen|cutebot|move", "side": "left|right"}
PROCEDURES = "Forward Backward Stop"


def make(settings):
    return Motors(settings, 3 if settings["side"] == "right" else 2)
