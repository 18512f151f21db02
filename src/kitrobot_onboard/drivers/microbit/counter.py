# How many things are in store: one more for each time that something passes a light barrier or a key at `more`, one
# less at `less`, from `first`. A pin is read at each tick, so what passes must stay for two ticks.

from kitrobot_onboard.drivers.any.shared.counting import Counter
from kitrobot_onboard.drivers.microbit.pins import pin

SETTINGS = {"more": "pin", "less": "pin?", "first": "0..1000 = 0", "active": "high|low = low"}


def level_of(number):
    found = pin(number)
    found.set_pull(found.PULL_UP)
    return found.read_digital


def make(settings):
    return Counter(settings, level_of)
