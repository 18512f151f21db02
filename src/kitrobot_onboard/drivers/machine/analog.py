# Whatever gives a voltage for what it measures: the sensor's least value at `low`, its largest at `high`, in a straight
# line between, in parts of 65535 of the board's own voltage. Less than `floor` it never gives: nothing is plugged in.

from machine import ADC

from kitrobot_onboard.drivers.machine.pins import pin

SETTINGS = {"pin": "input", "low": "0..65535 = 0", "high": "0..65535 = 65535", "floor": "0..65535 = 0"}


class Analog:
    def __init__(self, settings):
        self.adc = ADC(pin(settings["pin"]))
        if hasattr(ADC, "ATTN_11DB"):  # an ESP32 sees only the lowest volt without it
            self.adc.atten(ADC.ATTN_11DB)
        self.low = int(settings.get("low", "0"))
        self.high = int(settings.get("high", "65535"))
        if self.low == self.high:
            raise ValueError("low and high are the same")
        self.floor = int(settings.get("floor", "0"))
        self.least = int(settings.get("min", "0"))
        self.most = int(settings.get("max", "100"))

    def read(self):
        voltage = self.adc.read_u16()
        if voltage < self.floor:
            raise OSError("no answer: not plugged in?")
        share = (voltage - self.low) * (self.most - self.least) // (self.high - self.low)
        return max(self.least, min(self.least + share, self.most))


make = Analog
