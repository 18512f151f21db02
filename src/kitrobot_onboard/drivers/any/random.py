# A new number at each tick, from the sensor's least value to its largest.

from random import randint

SETTINGS = {}


def make(settings):
    least = int(settings.get("min", "0"))
    most = int(settings.get("max", "100"))
    return lambda: randint(least, most)
