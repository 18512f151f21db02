# What the encoders of both wheels tell: each edge counts, whichever way a wheel turns. `counts`: how often both change
# together while the robot turns once around on the spot; so a wheel that is that far ahead of the other has turned it
# once around too.

from machine import Pin

from kitrobot_onboard.drivers.machine.pins import pin

NAMES = ("left-count", "right-count")
MOST = 50  # percent of its speed that a wheel loses at most, so that it never stands or goes back


class Edges:
    """Those at one pin."""

    def __init__(self, name):
        self.seen = 0
        pin(name, Pin.IN).irq(self.count, Pin.IRQ_RISING | Pin.IRQ_FALLING)

    def count(self, pin):
        self.seen += 1


edges = {}


def edges_of(settings):
    """The edges of the left and of the right wheel: one count for all drivers that name the pin."""
    for name in NAMES:
        if settings[name] not in edges:
            edges[settings[name]] = Edges(settings[name])
    return [edges[settings[name]] for name in NAMES]


class Encoders:
    """How far a robot has turned on the spot, where both wheels turn."""

    def __init__(self, settings):
        self.counts = int(settings["counts"])
        self.left, self.right = edges_of(settings)
        self.begun = 0

    def begin(self, speed):
        self.begun = self.left.seen + self.right.seen

    def turned(self):
        """In thousandths of a degree."""
        return (self.left.seen + self.right.seen - self.begun) * 360000 // self.counts


class Straight:
    """Keeps a robot straight: the wheel that is ahead goes slower, by `straight` percent for each degree off."""

    def __init__(self, settings):
        self.counts = int(settings["counts"])
        self.straight = int(settings.get("straight", "3"))
        self.left, self.right = edges_of(settings)
        self.begun = 0

    def begin(self):
        """From here on; what the wheels did before does not count."""
        self.begun = self.left.seen - self.right.seen

    def speeds(self, speed):
        """Of the left and of the right wheel, in percent, none faster than `speed`."""
        ahead = self.left.seen - self.right.seen - self.begun
        edges = min(abs(ahead), self.counts // 4)  # a quarter of a turn: more would be large numbers
        slower = abs(speed) * min(edges * 360 * self.straight // self.counts, MOST) // 100
        slow = speed + slower if speed < 0 else speed - slower
        return (slow, speed) if ahead > 0 else (speed, slow)


straights = {}


def straight_of(settings):
    """The one that both wheels share."""
    key = settings[NAMES[0]]
    if key not in straights:
        straights[key] = Straight(settings)
    return straights[key]
