# How many things are in store: one more for each time that something passes a light barrier or a key at `more`, one
# less at `less`, from `first`. A pin is read at each tick, so what passes must stay for two ticks.

from machine import Pin

from kitrobot_onboard.drivers.any.shared.counting import Counter
from kitrobot_onboard.drivers.machine.pins import pin

SETTINGS = {"more": "pin", "less": "pin?", "first": "0..1000 = 0", "active": "high|low = low"}


def make(settings):
    return Counter(settings, lambda name: pin(name, Pin.IN, Pin.PULL_UP).value)
