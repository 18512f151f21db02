# How the board is held, along one axis in thousandths of g, or whether it was shaken since it was asked last.

from microbit import accelerometer

SETTINGS = {"axis": "x|y|z = x", "what": "axis|shake = axis"}


def shaken():
    return 1 if accelerometer.was_gesture("shake") else 0


def make(settings):
    if settings.get("what") == "shake":
        return shaken
    return getattr(accelerometer, "get_" + settings.get("axis", "x"))
