# The module `neopixel` of a board that nothing is wired to: what is written goes into the log of `machine`.

from machine import log


class NeoPixel:
    def __init__(self, pin, count):
        self.name = pin.name
        self.colours = [(0, 0, 0)] * count

    def fill(self, colour):
        self.colours = [colour] * len(self.colours)

    def __setitem__(self, at, colour):
        self.colours[at] = colour

    def show(self):  # as a micro:bit calls it
        self.write()

    def write(self):
        log.append((self.name, "pixels", list(self.colours)))
