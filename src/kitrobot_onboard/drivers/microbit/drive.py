# A kit of a micro:bit that drives straight on: Maqueen (DFRobot), Cutebot (ELECFREAKS), :MOVE Motor (Kitronik),
# or two motors at a motor board that is wired to pins. A distance it drives by the clock, at half speed: at full speed
# `speed` millimetres a second.

from kitrobot_onboard.drivers.microbit.shared.motors import Motors

SETTINGS = {
    "kit": "maqueen|cutebot|move|pins",
    "left-forward": "shared where kit=pins",
    "left-backward": "shared where kit=pins",
    "left-power": "shared? where kit=pins",
    "right-forward": "shared where kit=pins",
    "right-backward": "shared where kit=pins",
    "right-power": "shared? where kit=pins",
    "speed": "10..5000 = 400",
}
PROCEDURES = "Advance Reverse DriveBy BackBy Stop"


def make(settings):
    return Motors(settings, 0)
