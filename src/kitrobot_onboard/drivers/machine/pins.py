# What drivers share: a pin by its name, a pin that gives a square wave.

from machine import PWM, Pin

FULL = 65535  # of a duty: always on
SERVO_HZ = 50


def pin(name, *mode):
    """The pin that the settings name, by number or by the name that the board gives it."""
    return Pin(int(name) if name.isdigit() else name, *mode)


class Wave:
    """A square wave at a pin, on for a part of the time: 0 to FULL."""

    def __init__(self, name, frequency):
        try:
            self.pwm = PWM(pin(name), freq=frequency, duty_u16=0)
        except TypeError:  # boards that take no such words
            self.pwm = PWM(pin(name))
            self.pwm.freq(frequency)
            self.give(0)

    def give(self, part):
        if hasattr(self.pwm, "duty_u16"):
            self.pwm.duty_u16(part)
        else:
            self.pwm.duty(part >> 6)

    def angle(self, degrees):
        """For a servo: a pulse of 0.5 ms (0 degrees) to 2.5 ms (180), 50 times a second."""
        self.give((500 + degrees * 100 // 9) * FULL // 20000)
