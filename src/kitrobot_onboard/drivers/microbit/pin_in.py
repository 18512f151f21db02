# What is on a pin: 0 or 1, or 0 to 1023 for up to 3.3 V.

import microbit

SETTINGS = {"pin": "pin", "mode": "digital|analog = digital"}


def make(settings):
    pin = getattr(microbit, "pin" + settings["pin"])
    return pin.read_analog if settings.get("mode") == "analog" else pin.read_digital
