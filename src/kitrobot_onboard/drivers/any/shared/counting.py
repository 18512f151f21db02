# What is counted at pins, which are read at each tick; `level` functions give what a pin reads, 0 or 1.


class Marks:
    """The number of a section of a road, from a code of dark bars beside the line: one bar more than its number, each
    not wider than the ground between two. A code is over when no bar came for `gap` ms; until the next one the number
    stays. `clock` has ticks_ms and ticks_diff.
    """

    def __init__(self, settings, level, clock):
        self.level = level
        self.clock = clock
        self.dark = 0 if settings.get("dark") == "low" else 1
        self.gap = int(settings.get("gap", "400"))
        self.number = int(settings.get("min", "0"))
        self.bars = 0
        self.was = level() == self.dark
        self.since = clock.ticks_ms()

    def read(self):
        dark = self.level() == self.dark
        if dark != self.was:
            self.was = dark
            self.since = self.clock.ticks_ms()
            self.bars += dark
        elif self.bars and not dark and self.clock.ticks_diff(self.clock.ticks_ms(), self.since) >= self.gap:
            self.number = self.bars - 1
            self.bars = 0
        return self.number


class Counter:
    """How many things are in store, from `first` on: one more for each time that something passes the pin `more`, one
    less at `less`. What passes must stay for two ticks. `level_of` gives the function that reads a pin of that name.
    """

    def __init__(self, settings, level_of):
        self.active = 1 if settings.get("active") == "high" else 0
        self.least = int(settings.get("min", "0"))
        self.most = int(settings.get("max", "100"))
        self.value = int(settings.get("first", "0"))
        self.doors = []
        for name, step in (("more", 1), ("less", -1)):
            if name in settings:
                level = level_of(settings[name])
                self.doors.append([level, step, level() == self.active])

    def read(self):
        for door in self.doors:
            there = door[0]() == self.active
            if there and not door[2]:
                self.value = max(self.least, min(self.value + door[1], self.most))
            door[2] = there
        return self.value
