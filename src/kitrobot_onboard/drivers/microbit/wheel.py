# One wheel of a kit of a micro:bit (see `drive`).

from kitrobot_onboard.drivers.microbit.shared.motors import Motors

SETTINGS = {
    "kit": "maqueen|cutebot|move|pins",
    "left-forward": "shared where kit=pins",
    "left-backward": "shared where kit=pins",
    "left-power": "shared? where kit=pins",
    "right-forward": "shared where kit=pins",
    "right-backward": "shared where kit=pins",
    "right-power": "shared? where kit=pins",
    "side": "left|right",
}
PROCEDURES = "Forward Backward Stop"


def make(settings):
    return Motors(settings, 3 if settings["side"] == "right" else 2)
