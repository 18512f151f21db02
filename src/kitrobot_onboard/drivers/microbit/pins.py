# What drivers share: a pin by its number, and one that moves a servo or gives a part of full power. All pins of a
# micro:bit have one period, so it is that of servos for all.

import microbit


def pin(number):
    return getattr(microbit, "pin" + number)


class Wave:
    """A square wave at a pin, on for a part of the time: 0 to 65535."""

    def __init__(self, number):
        self.pin = pin(number)
        self.pin.write_digital(0)

    def give(self, part):
        if part:
            self.pin.write_analog(part >> 6)
        else:
            self.pin.write_digital(0)

    def angle(self, degrees):
        """For a servo: a pulse of 0.5 ms (0 degrees) to 2.5 ms (180) every 20 ms, in 1023rds of that."""
        self.pin.set_analog_period(20)
        self.pin.write_analog(26 + degrees * 102 // 180)
