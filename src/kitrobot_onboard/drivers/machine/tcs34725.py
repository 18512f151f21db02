# A colour sensor TCS34725 (ams) above the ground: 1 red, 2 green, 3 blue, 0 for none of them. A colour is seen when it
# is larger than both others by `margin` percent, and there is light at all.

from kitrobot_onboard.drivers.any.shared.colours import ADDRESS, Colour
from kitrobot_onboard.drivers.machine.shared.buses import bus_of

SETTINGS = {
    "sda": "shared",
    "scl": "shared",
    "bus": "0..1 = 0",
    "margin": "1..200 = 25",
    "dark": "0..65535 = 30",
}


def make(settings):
    bus = bus_of(settings)
    return Colour(
        settings,
        lambda register, value: bus.writeto_mem(ADDRESS, register, bytes((value,))),
        lambda register, count: bus.readfrom_mem(ADDRESS, register, count),
    )
