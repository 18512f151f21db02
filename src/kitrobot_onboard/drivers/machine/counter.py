# How many things are in store: one more for each time that something passes a light barrier or a key at `more`, one
# less at `less`, from `first`. A pin is read at each tick, so what passes must stay for two ticks.

from machine import Pin

from kitrobot_onboard.drivers.machine.pins import pin

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
                made = pin(settings[name], Pin.IN, Pin.PULL_UP)
                self.doors.append([made, step, made.value() == self.active])

    def read(self):
        for door in self.doors:
            there = door[0].value() == self.active
            if there and not door[2]:
                self.value = max(self.least, min(self.value + door[1], self.most))
            door[2] = there
        return self.value


make = Counter
