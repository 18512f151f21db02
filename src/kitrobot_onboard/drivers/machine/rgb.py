# A lamp of three colours at three pins.

from machine import Pin

from kitrobot_onboard.drivers.machine.pins import pin

SETTINGS = {
    "red": "pin",
    "green": "pin",
    "blue": "pin",
    "active": "high|low = high",
    "colour": "white|red|green|blue|yellow|magenta|cyan = white",
}
PROCEDURES = "LightOn LightOff"

PARTS = {
    "white": (1, 1, 1),
    "red": (1, 0, 0),
    "green": (0, 1, 0),
    "blue": (0, 0, 1),
    "yellow": (1, 1, 0),
    "magenta": (1, 0, 1),
    "cyan": (0, 1, 1),
}


class Lamp:
    def __init__(self, settings):
        self.off = 1 if settings.get("active") == "low" else 0
        self.colour = PARTS[settings.get("colour", "white")]
        self.pins = [pin(settings[name], Pin.OUT) for name in ("red", "green", "blue")]
        self.stop()

    def do(self, procedure, arguments):
        self.show(self.colour if procedure == "LightOn" else (0, 0, 0))

    def show(self, parts):
        for each, part in zip(self.pins, parts):
            each.value(1 - self.off if part else self.off)

    def stop(self):
        self.show((0, 0, 0))


make = Lamp
