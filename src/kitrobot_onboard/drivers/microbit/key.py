# A button of the board, or one of your own that joins a pin to ground: 1 while it is pressed.

import microbit

SETTINGS = {"which": "a|b = a", "pin": "pin?"}


class Key:
    def __init__(self, settings):
        if "pin" in settings:
            self.pin = getattr(microbit, "pin" + settings["pin"])
            self.pin.set_pull(self.pin.PULL_UP)
            self.read = self.joined
        else:
            self.read = getattr(microbit, "button_" + settings.get("which", "a")).is_pressed

    def joined(self):
        return 1 - self.pin.read_digital()


def make(settings):
    return Key(settings)
