# Something that a pin switches on and off: a relay, a transistor.

import microbit

SETTINGS = {"pin": "pin", "active": "high|low = high"}
PROCEDURES = "SwitchOn SwitchOff"


class Switch:
    def __init__(self, settings):
        self.pin = getattr(microbit, "pin" + settings["pin"])
        self.on = 0 if settings.get("active") == "low" else 1
        self.stop()

    def do(self, procedure, arguments):
        self.pin.write_digital(self.on if procedure == "SwitchOn" else 1 - self.on)

    def stop(self):
        self.pin.write_digital(1 - self.on)


make = Switch
