# A colour sensor TCS34725 (ams) above the ground, at the I2C bus of the edge, pins 19 and 20: 1 red, 2 green, 3 blue, 0
# for none of them. A colour is seen when it is larger than both others by `margin` percent, and there is light at all.

from kitrobot_onboard.drivers.microbit.shared.colours import Colour

SETTINGS = {"margin": "1..200 = 25", "dark": "0..65535 = 30"}


def make(settings):
    return Colour(settings, False)
