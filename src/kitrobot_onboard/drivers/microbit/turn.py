# A kit of a micro:bit that turns on the spot, counter-clockwise, by the clock: at full speed `rate` degrees a second.

from kitrobot_onboard.drivers.microbit.shared.motors import Motors

SETTINGS = {
    "kit": "maqueen|cutebot|move|pins",
    "left-forward": "shared where kit=pins",
    "left-backward": "shared where kit=pins",
    "left-power": "shared? where kit=pins",
    "right-forward": "shared where kit=pins",
    "right-backward": "shared where kit=pins",
    "right-power": "shared? where kit=pins",
    "rate": "10..2000 = 180",
}
PROCEDURES = "AbsoluteTurn Turn LeftBy RightBy Stop"


def make(settings):
    return Motors(settings, 1)
