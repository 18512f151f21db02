# A pin for whatever is wired to it: on or off, a part of full power, the angle of a servo.

import microbit

SETTINGS = {"pin": "pin"}
PROCEDURES = "Write Analog Servo"


class Out:
    def __init__(self, settings):
        self.pin = getattr(microbit, "pin" + settings["pin"])

    def do(self, procedure, arguments):
        value = max(0, arguments[0])
        if procedure == "Write":
            self.pin.write_digital(1 if value else 0)
        elif procedure == "Servo":
            # Pulses of 0.5 to 2.5 ms every 20 ms, in 1023rds of that.
            self.pin.set_analog_period(20)
            self.pin.write_analog(26 + min(value, 180) * 102 // 180)
        else:
            self.pin.set_analog_period(1)
            self.pin.write_analog(min(value, 1023))

    def stop(self):
        self.pin.write_digital(0)


def make(settings):
    return Out(settings)
