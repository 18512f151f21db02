# A button of the board, or of one's own at a pin that it joins to ground: 1 while it is pressed.

import microbit


class Key:
    def __init__(self, settings):
        if "pin" in settings:
            pin = getattr(microbit, "pin" + settings["pin"])
            pin.set_pull(pin.PULL_UP)
            self.read = lambda: 1 - pin.read_digital()
        else:
            self.read = getattr(microbit, "button_" + settings.get("which", "a")).is_pressed

    def stop(self):
        pass


def make(settings):
    return Key(settings)
