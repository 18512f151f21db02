# The touch logo of a micro:bit V2: 1 while a finger is on it.

from microbit import pin_logo

CHIP = "nrf52833"
SETTINGS = {}


def make(settings):
    return pin_logo.is_touched
