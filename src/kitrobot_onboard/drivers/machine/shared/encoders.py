# How far a robot has turned, from the encoders of both wheels: each edge counts, whichever way, since both wheels turn
# during a turn on the spot.

from machine import Pin

from kitrobot_onboard.drivers.machine.pins import pin


class Encoders:
    def __init__(self, settings):
        self.counts = int(settings["counts"])
        self.seen = 0
        for name in ("left-count", "right-count"):
            pin(settings[name], Pin.IN).irq(self.count, Pin.IRQ_RISING | Pin.IRQ_FALLING)

    def count(self, pin):
        self.seen += 1

    def begin(self, speed):
        self.seen = 0

    def turned(self):
        """In thousandths of a degree."""
        return self.seen * 360000 // self.counts
