# A pin that something is wired to: 0 or 1, or, as analogue, 0 to 1023 as on a micro:bit.

from machine import ADC, Pin

from kitrobot_onboard.drivers.machine.pins import pin

SETTINGS = {"pin": "input", "mode": "digital|analog = digital"}


class Digital:
    def __init__(self, settings):
        self.read = pin(settings["pin"], Pin.IN).value


class Analog:
    def __init__(self, settings):
        self.adc = ADC(pin(settings["pin"]))
        if hasattr(ADC, "ATTN_11DB"):  # an ESP32 sees only the lowest volt without it
            self.adc.atten(ADC.ATTN_11DB)

    def read(self):
        return self.adc.read_u16() >> 6


def make(settings):
    return Analog(settings) if settings.get("mode") == "analog" else Digital(settings)
