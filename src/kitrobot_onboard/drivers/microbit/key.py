# A button of the board, or one of your own that joins a pin to ground: 1 while it is pressed.

import microbit

SETTINGS = {"which": "a|b = a", "pin": "pin?"}


def make(settings):
    if "pin" in settings:
        pin = getattr(microbit, "pin" + settings["pin"])
        pin.set_pull(pin.PULL_UP)
        return lambda: 1 - pin.read_digital()
    return getattr(microbit, "button_" + settings.get("which", "a")).is_pressed
