# A reflectance sensor of the RC kind (see `shared.decays`) that looks at the ground: its least value on bright ground,
# one more on a dark line, which keeps it high for `threshold` microseconds or longer.

from kitrobot_onboard.drivers.machine.shared.decays import Decay

SETTINGS = {"pin": "input", "emitter": "shared", "threshold": "50..1000 = 512"}


class Line:
    def __init__(self, settings):
        self.sensor = Decay(settings["pin"], settings["emitter"])
        self.least = int(settings.get("min", "0"))
        self.threshold = int(settings.get("threshold", "512"))

    def read(self):
        return self.least + (self.sensor.look(self.threshold) >= self.threshold)


make = Line
