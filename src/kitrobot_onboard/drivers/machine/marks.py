# The number of a section of a road, from a code of dark bars beside the line: one bar more than its number, each not
# wider than the ground between two. A code is over when no bar came for `gap` ms; until the next one the number stays.

import time

from machine import Pin

from kitrobot_onboard.drivers.any.shared.counting import Marks
from kitrobot_onboard.drivers.machine.pins import pin

SETTINGS = {"pin": "input", "dark": "low|high = high", "gap": "40..5000 = 400"}


def make(settings):
    return Marks(settings, pin(settings["pin"], Pin.IN).value, time)
