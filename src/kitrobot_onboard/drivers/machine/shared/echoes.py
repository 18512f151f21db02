# Ultrasonic range finders, for the drivers `ultrasonic` and `near`: asked by a pulse, they answer by one as long as the
# sound was on its way.
#
# The answer is waited for, 5.8 microseconds for each millimetre of `reach`: up to 6 ms for a metre. So they take turns:
# one is asked at a time, and no sooner than the last echo has died away. Between its turns a finder gives what it last
# saw; one that nobody looks at (it is held) misses its turn. One that begins no answer at all is not plugged in, or
# broken: even where nothing stands a finder answers.

import time

from machine import Pin, time_pulse_us

from kitrobot_onboard.drivers.machine.pins import pin

QUIET_MS = 30  # between two questions
LATE_US = 1000  # from the question to the beginning of the answer
MISSED_MS = 100  # after so long the turn of one that nobody looks at is over
SILENT = 5  # questions without the beginning of an answer, one after the other
# Sound goes 343 m a second, there and back: 0.1715 mm a microsecond.
MM = 1715
SCALE = 10000

finders = []  # the one whose turn it is first


class Finder:
    """One at two pins that looks `reach` mm far."""

    def __init__(self, trigger, echo, reach):
        self.trigger = pin(trigger, Pin.OUT)
        self.trigger.value(0)
        self.echo = pin(echo, Pin.IN)
        self.wait = LATE_US + reach * SCALE // MM
        self.width = None
        self.silent = 0
        self.due = time.ticks_ms()
        finders.append(self)

    def look(self):
        """Microseconds of the last answer, None where nothing was seen. Raises OSError when none begins."""
        late = time.ticks_diff(time.ticks_ms(), finders[0].due)
        if late > MISSED_MS and finders[0] is not self:
            finders.remove(self)
            finders.insert(0, self)
        if finders[0] is self and late >= 0:
            if not self.echo.value():  # else it still waits for an echo: the next one's turn
                self.ask()
            finders.append(finders.pop(0))
            finders[0].due = time.ticks_add(time.ticks_ms(), QUIET_MS)
        if self.silent >= SILENT:
            self.silent = 0
            raise OSError("no answer: not plugged in?")
        return self.width

    def ask(self):
        self.trigger.value(1)
        time.sleep_us(10)
        self.trigger.value(0)
        width = time_pulse_us(self.echo, 1, self.wait)
        self.silent = self.silent + 1 if width == -2 else 0
        self.width = width if width >= 0 else None
