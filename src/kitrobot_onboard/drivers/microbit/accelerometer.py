# How the board is held, along one axis in thousandths of g, or whether it was shaken since it was asked last.

from microbit import accelerometer

SETTINGS = {"axis": "x|y|z = x", "what": "axis|shake = axis"}


class Accelerometer:
    def __init__(self, settings):
        if settings.get("what") == "shake":
            self.read = self.shaken
        else:
            self.read = getattr(accelerometer, "get_" + settings.get("axis", "x"))

    def shaken(self):
        return 1 if accelerometer.was_gesture("shake") else 0


def make(settings):
    return Accelerometer(settings)
