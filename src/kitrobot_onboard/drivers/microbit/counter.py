# How many things are in store: one more for each time that something passes a light barrier or a key at `more`, one
# less at `less`, from `first`. A pin is read at each tick, so what passes must stay for two ticks. All of it is here:
# on the micro:bit of 2016 the stack ends in a driver that brings helpers along.

import microbit

SETTINGS = {"more": "pin", "less": "pin?", "first": "0..1000 = 0", "active": "high|low = low"}


class Counter:
    def __init__(self, settings):
        self.active = 1 if settings.get("active") == "high" else 0
        self.least = int(settings.get("min", "0"))
        self.most = int(settings.get("max", "100"))
        self.value = int(settings.get("first", "0"))
        self.doors = []
        for name, step in (("more", 1), ("less", -1)):
            if name in settings:
                pin = getattr(microbit, "pin" + settings[name])
                pin.set_pull(pin.PULL_UP)
                self.doors.append([pin, step, pin.read_digital() == self.active])

    def read(self):
        for door in self.doors:
            there = door[0].read_digital() == self.active
            if there and not door[2]:
                self.value = max(self.least, min(self.value + door[1], self.most))
            door[2] = there
        return self.value


make = Counter
