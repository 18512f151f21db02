# A door that a servo at a pin moves; it is there after `time` from one end to the other. All of it
# is here: on the micro:bit of 2016 the stack ends in a driver that brings helpers along.

import microbit

SETTINGS = {"pin": "pin", "open": "0..180 = 90", "closed": "0..180 = 0", "time": "1..60000 = 1000"}
PROCEDURES = "Open Close"


class Door:
    def __init__(self, settings):
        self.pin = getattr(microbit, "pin" + settings["pin"])
        self.open = int(settings.get("open", "90"))
        self.closed = int(settings.get("closed", "0"))
        self.needed = int(settings.get("time", "1000"))
        self.until = 0
        self.stop()

    def do(self, procedure, arguments):
        angle = self.open if procedure == "Open" else self.closed
        self.pin.set_analog_period(20)
        self.pin.write_analog(26 + angle * 102 // 180)
        self.until = microbit.running_time() + self.needed

    def done(self):
        return microbit.running_time() >= self.until

    def stop(self):
        self.pin.write_digital(0)
        self.until = 0


make = Door
