# Something that a pin switches on and off: a relay, a transistor.

from machine import Pin

from kitrobot_onboard.drivers.machine.pins import pin

SETTINGS = {"pin": "pin", "active": "high|low = high"}
PROCEDURES = "SwitchOn SwitchOff"


class Switch:
    def __init__(self, settings):
        self.on = 0 if settings.get("active") == "low" else 1
        self.pin = pin(settings["pin"], Pin.OUT)
        self.stop()

    def do(self, procedure, arguments):
        self.pin.value(self.on if procedure == "SwitchOn" else 1 - self.on)

    def stop(self):
        self.pin.value(1 - self.on)


make = Switch
