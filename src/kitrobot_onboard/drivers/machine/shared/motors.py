# The two motors that drive a robot, shared by the drivers `drive`, `turn`, `wheel` and `road`: each says how it wants
# the robot to move, and the wheels turn by the sum. How a motor is wired:
#
#     forward, backward           two inputs, both with a square wave: DRV8833, L9110, L298N with its bridges on
#     forward, backward, power    two inputs for the direction, a third with a square wave: TB6612, L298N
#     bridge="direction"          `forward` has a square wave, `backward` is high for backward: DRV8835, DRV8838

from machine import Pin

from kitrobot_onboard.drivers.machine.pins import FULL, Wave, pin

LEFT = 0
RIGHT = 1
SIDES = ("left", "right")


class Motor:
    def __init__(self, settings, side):
        frequency = int(settings.get("frequency", "1000"))
        names = settings[side + "-forward"], settings[side + "-backward"]
        power = settings.get(side + "-power")
        self.waves = self.levels = None
        if settings.get("bridge") == "direction":
            self.levels = [pin(names[1], Pin.OUT)]
            self.power = Wave(names[0], frequency)
        elif power is not None:
            self.levels = [pin(name, Pin.OUT) for name in names]
            self.power = Wave(power, frequency)
        else:
            self.waves = [Wave(name, frequency) for name in names]
        self.flipped = settings.get(side + "-flipped") == "yes"
        self.trim = int(settings.get(side + "-trim", "100"))
        self.least = int(settings.get("least", "0"))
        self.now = None

    def give(self, percent):
        """-100 full speed backward, 100 full speed forward."""
        if percent == self.now:
            return
        self.now = percent
        part = min(abs(percent), 100)
        if part:
            part = (self.least + (100 - self.least) * part // 100) * self.trim * FULL // 10000
        back = (percent < 0) != self.flipped
        if self.waves is not None:
            self.waves[not back].give(0)  # never both inputs at once
            self.waves[back].give(part)
            return
        if len(self.levels) == 1:
            self.levels[0].value(1 if back and part else 0)
        else:
            self.levels[not back].value(0)
            self.levels[back].value(1 if part else 0)
        self.power.give(part)


class Base:
    """`wanted`: percent of full speed, by who wants it, of each wheel."""

    def __init__(self, settings):
        self.motors = [Motor(settings, side) for side in SIDES]
        self.wanted = {}
        self.move()

    def want(self, who, left, right):
        self.wanted[who] = left, right
        self.move()

    def move(self):
        for side in (LEFT, RIGHT):
            percent = sum([wanted[side] for wanted in self.wanted.values()])
            self.motors[side].give(max(-100, min(percent, 100)))

    def stop(self):
        self.wanted.clear()
        for motor in self.motors:
            motor.now = None  # told again, whatever was told before
            motor.give(0)


bases = {}


def base_of(settings):
    """The base at these pins: the same for all drivers that name them."""
    key = settings["left-forward"]
    if key not in bases:
        bases[key] = Base(settings)
    return bases[key]
