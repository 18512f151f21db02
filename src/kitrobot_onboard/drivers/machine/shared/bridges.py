# How a motor is wired to what turns it:
#
#     forward, backward           two inputs, both with a square wave: DRV8833, L9110, L298N with its bridges on
#     forward, backward, power    two inputs for the direction, a third with a square wave: TB6612, L298N
#     bridge="direction"          `forward` has a square wave, `backward` is high for backward: DRV8835, DRV8838
#
# These are pins of the board or, with `motors`, outputs of a chip on an I2C bus (see `motor_chips`).

from machine import Pin

from kitrobot_onboard.drivers.machine.pins import FULL, Wave, pin

NEARLY_FULL = FULL - 1  # a wave that is always on brakes an XRP Beta (motor.py of its maker's XRPLib)


class Bridge:
    """How one motor is wired. `wave` and `level` make an output of its name; `wave` is told the frequency in Hz too."""

    def __init__(self, settings, side, wave, level):
        frequency = int(settings.get("frequency", "1000"))
        names = settings[side + "-forward"], settings[side + "-backward"]
        power = settings.get(side + "-power")
        self.waves = self.levels = None
        if settings.get("bridge") == "direction":
            self.levels = [level(names[1])]
            self.power = wave(names[0], frequency)
        elif power is not None:
            self.levels = [level(name) for name in names]
            self.power = wave(power, frequency)
        else:
            self.waves = [wave(name, frequency) for name in names]

    def turn(self, part, back):
        """`part`: 0 to FULL; `back`: whether backward."""
        if self.waves is not None:
            self.waves[not back].give(0)  # never both inputs at once
            self.waves[back].give(part)
            return
        if len(self.levels) == 1:
            self.levels[0].value(1 if back and part else 0)
        else:
            self.levels[not back].value(0)
            self.levels[back].value(1 if part else 0)
        self.power.give(min(part, NEARLY_FULL) if len(self.levels) == 1 else part)


class Pins:
    """What turns motors that are wired to pins of the board; a chip in its place has the same two methods."""

    def motor(self, settings, side):
        """Has `turn(part, back)`, as a Bridge."""
        return Bridge(settings, side, Wave, lambda name: pin(name, Pin.OUT))

    def stop(self):
        """Comes before all motors are told to stand still."""
