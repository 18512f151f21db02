# A lamp of NeoPixels (WS2812) in a row at one pin.

from neopixel import NeoPixel

from kitrobot_onboard.drivers.microbit.pins import pin

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
        self.pixels = NeoPixel(pin(settings["pin"]), self.count)
        self.colour = tuple([int(settings.get(name, "40")) for name in ("red", "green", "blue")])
        self.stop()

    def do(self, procedure, arguments):
        self.show(self.colour if procedure == "LightOn" else (0, 0, 0))

    def show(self, colour):
        for at in range(self.count):
            self.pixels[at] = colour
        self.pixels.show()

    def stop(self):
        self.show((0, 0, 0))


make = Lamp
