# A lamp of NeoPixels (WS2812) in a row at one pin. Nothing here calls a function that calls another: on the micro:bit
# of 2016 the stack ends in one that does.

import microbit
from neopixel import NeoPixel

SETTINGS = {
    "pin": "pin",
    "count": "1..64 = 1",
    "red": "0..255 = 40",
    "green": "0..255 = 40",
    "blue": "0..255 = 40",
}
PROCEDURES = "LightOn LightOff"


class Lamp:
    def __init__(self, settings):
        self.count = int(settings.get("count", "1"))
        self.pixels = NeoPixel(getattr(microbit, "pin" + settings["pin"]), self.count)
        self.colour = (
            int(settings.get("red", "40")),
            int(settings.get("green", "40")),
            int(settings.get("blue", "40")),
        )
        self.stop()

    def do(self, procedure, arguments):
        for at in range(self.count):
            self.pixels[at] = self.colour if procedure == "LightOn" else (0, 0, 0)
        self.pixels.show()

    def stop(self):
        for at in range(self.count):
            self.pixels[at] = (0, 0, 0)
        self.pixels.show()


make = Lamp
