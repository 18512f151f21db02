# The two motors that drive a robot, shared by the drivers `drive`, `turn`, `wheel` and `road`: each says how it wants
# the robot to move, and the wheels turn by the sum. How they are wired: see `bridges`.

from kitrobot_onboard.drivers.machine.pins import FULL
from kitrobot_onboard.drivers.machine.shared.bridges import Pins

LEFT = 0
RIGHT = 1
SIDES = ("left", "right")
PINS = Pins()


class Motor:
    def __init__(self, settings, side, turns):
        self.bridge = turns.motor(settings, side)
        self.flipped = settings.get(side + "-flipped") == "yes"
        self.trim = int(settings.get(side + "-trim", "100"))
        self.least = int(settings.get("least", "0"))
        self.now = None

    def give(self, percent):
        """-100 full speed backward, 100 full speed forward."""
        if percent == self.now:
            return
        self.now = None  # until it is told: a chip may not answer
        part = min(abs(percent), 100)
        if part:
            part = (self.least + (100 - self.least) * part // 100) * self.trim * FULL // 10000
        self.bridge.turn(part, (percent < 0) != self.flipped)
        self.now = percent


class Base:
    """`wanted`: percent of full speed, by who wants it, of each wheel."""

    def __init__(self, settings, turns):
        self.turns = turns
        self.motors = [Motor(settings, side, turns) for side in SIDES]
        self.wanted = {}
        self.wheels = [0, 0]  # what each wheel was told by itself
        self.move()

    def want(self, who, left, right):
        self.wanted[who] = left, right
        self.move()

    def is_alone(self, who):
        """Whether nobody else wants to move."""
        return not any([any(self.wanted[other]) for other in self.wanted if other != who])

    def move(self):
        for side in (LEFT, RIGHT):
            percent = sum([wanted[side] for wanted in self.wanted.values()])
            self.motors[side].give(max(-100, min(percent, 100)))

    def stop(self):
        self.wanted.clear()
        self.wheels = [0, 0]
        for motor in self.motors:
            motor.now = None  # told again, whatever was told before
        self.turns.stop()
        for motor in self.motors:
            motor.give(0)


bases = {}


def base_of(settings):
    """The base at these pins, or these outputs of a chip: the same for all drivers that name them."""
    turns = PINS
    if settings.get("motors", "pins") != "pins":
        from kitrobot_onboard.drivers.machine.shared.motor_chips import chip_of

        turns = chip_of(settings)
    key = turns, settings["left-forward"]
    if key not in bases:
        bases[key] = Base(settings, turns)
    return bases[key]
