# I2C buses: one for each pair of pins, shared by all that is on it.

from machine import I2C

from kitrobot_onboard.drivers.machine.pins import pin

buses = {}


def bus_of(settings):
    """The bus at the pins `sda` and `scl`; `bus` is the number of the board's own part for it."""
    key = settings["sda"], settings["scl"]
    if key not in buses:
        buses[key] = I2C(int(settings.get("bus", "0")), sda=pin(key[0]), scl=pin(key[1]), freq=100000)
    return buses[key]
