# A sensor that looks at the ground: its least value on bright ground, one more on a dark line. Read as digital, or,
# with a threshold, as analogue and compared with that.

from machine import ADC, Pin

from kitrobot_onboard.drivers.machine.pins import pin

SETTINGS = {"pin": "input", "threshold": "1..65535?", "dark": "low|high = high"}


class Line:
    def __init__(self, settings):
        self.least = int(settings.get("min", "0"))
        self.dark = settings.get("dark", "high") == "high"
        self.threshold = int(settings.get("threshold", "0"))
        if self.threshold:
            self.pin = ADC(pin(settings["pin"]))
            if hasattr(ADC, "ATTN_11DB"):  # an ESP32 sees only the lowest volt without it
                self.pin.atten(ADC.ATTN_11DB)
        else:
            self.pin = pin(settings["pin"], Pin.IN)

    def read(self):
        high = self.pin.read_u16() >= self.threshold if self.threshold else self.pin.value() == 1
        return self.least + (high == self.dark)


make = Line
