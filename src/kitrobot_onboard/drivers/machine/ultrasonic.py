# An ultrasonic range finder that is asked by a pulse and answers by one as long as the sound was on its way: HC-SR04
# and its kin. The sensor's least value is touching, its largest is `reach` or more.
#
# The answer is waited for, 5.8 microseconds for each millimetre of `reach`: up to 6 ms for a metre. So they take turns:
# one is asked at a time, and no sooner than the last echo has died away. Between its turns a finder gives what it last
# saw.

import time

from machine import Pin, time_pulse_us

from kitrobot_onboard.drivers.machine.pins import pin

SETTINGS = {"trigger": "pin", "echo": "pin", "reach": "20..4000 = 1000"}

QUIET_MS = 30  # between two questions
LATE_US = 1000  # from the question to the beginning of the answer
# Sound goes 343 m a second, there and back: 0.1715 mm a microsecond.
MM = 1715
SCALE = 10000

finders = []  # the one whose turn it is first


class Finder:
    def __init__(self, settings):
        self.trigger = pin(settings["trigger"], Pin.OUT)
        self.trigger.value(0)
        self.echo = pin(settings["echo"], Pin.IN)
        self.reach = int(settings.get("reach", "1000"))
        self.least = int(settings.get("min", "0"))
        self.most = int(settings.get("max", "100"))
        self.seen = self.most
        self.due = time.ticks_ms()
        finders.append(self)

    def read(self):
        if finders[0] is self and time.ticks_diff(time.ticks_ms(), self.due) >= 0:
            if not self.echo.value():  # else it still waits for an echo, or is broken: the next one's turn
                self.ask()
            finders.append(finders.pop(0))
            finders[0].due = time.ticks_add(time.ticks_ms(), QUIET_MS)
        return self.seen

    def ask(self):
        self.trigger.value(1)
        time.sleep_us(10)
        self.trigger.value(0)
        width = time_pulse_us(self.echo, 1, LATE_US + self.reach * SCALE // MM)
        span = self.most - self.least
        seen = self.most
        if width >= 0:
            seen = min(seen, self.least + (width * MM * span + self.reach * SCALE // 2) // (self.reach * SCALE))
        self.seen = seen


make = Finder
