# The 5 x 5 lights as a lamp: all on, or none.

from microbit import Image, display

SETTINGS = {}
PROCEDURES = "LightOn LightOff"


class Lamp:
    def do(self, procedure, arguments):
        if procedure == "LightOn":
            display.show(Image("99999:99999:99999:99999:99999"))
        else:
            self.stop()

    def stop(self):
        display.show(Image())


def make(settings):
    return Lamp()
