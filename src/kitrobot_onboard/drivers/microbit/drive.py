# A kit of a micro:bit that drives straight on: Maqueen (DFRobot), Cutebot (ELECFREAKS), :MOVE Motor (Kitronik),
# or two motors at a motor board that is wired to pins.

from kitrobot_onboard.drivers.microbit.shared.motors import Motors

SETTINGS = {
    "kit": "maqueen|cutebot|move|pins",
    "left-forward": "shared where kit=pins",
    "left-backward": "shared where kit=pins",
    "left-power": "shared? where kit=pins",
    "right-forward": "shared where kit=pins",
    "right-backward": "shared where kit=pins",
    "right-power": "shared? where kit=pins",
}
PROCEDURES = "Advance Reverse Stop"


def make(settings):
    return Motors(settings, 0)
