# A push button that joins a pin to ground: 1 while it is pressed.

from machine import Pin

from kitrobot_onboard.drivers.machine.pins import pin

SETTINGS = {"pin": "pin"}


class Key:
    def __init__(self, settings):
        self.pin = pin(settings["pin"], Pin.IN, Pin.PULL_UP)

    def read(self):
        return 1 - self.pin.value()


make = Key
