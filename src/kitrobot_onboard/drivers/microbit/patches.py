# The number of a section of a road, from a patch of colour on the ground under a colour sensor TCS34725: `red`, `green`
# and `blue` say the number that each of them stands for. One that is seen in `steady` readings one after the other
# counts, so that the edge of a patch does not; until the next one, and on a colour without a number, the number stays.

from kitrobot_onboard.drivers.microbit.shared.colours import Colour

SETTINGS = {
    "margin": "1..200 = 25",
    "dark": "0..65535 = 30",
    "red": "0..1000?",
    "green": "0..1000?",
    "blue": "0..1000?",
    "steady": "1..50 = 2",
}


def make(settings):
    return Colour(settings, True)
