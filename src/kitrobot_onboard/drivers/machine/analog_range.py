# A range finder that gives a voltage, such as an infrared one: the sensor's least value at `near` or beyond, its
# largest at `far` or beyond, in a straight line between.

from machine import ADC

from kitrobot_onboard.drivers.machine.pins import pin

SETTINGS = {"pin": "input", "near": "0..65535", "far": "0..65535"}


class Range:
    def __init__(self, settings):
        self.adc = ADC(pin(settings["pin"]))
        if hasattr(ADC, "ATTN_11DB"):  # an ESP32 sees only the lowest volt without it
            self.adc.atten(ADC.ATTN_11DB)
        self.near = int(settings["near"])
        self.far = int(settings["far"])
        if self.near == self.far:
            raise ValueError("near and far are the same")
        self.least = int(settings.get("min", "0"))
        self.most = int(settings.get("max", "100"))

    def read(self):
        share = (self.adc.read_u16() - self.near) * (self.most - self.least) // (self.far - self.near)
        return max(self.least, min(self.least + share, self.most))


make = Range
