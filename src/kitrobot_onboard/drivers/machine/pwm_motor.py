# A motor with two inputs, one for each direction, behind a driver such as DRV8833, TB6612 or L298N.

from kitrobot_onboard.drivers.machine.pins import FULL, Wave

SETTINGS = {"forward": "pin", "backward": "pin", "frequency": "10..100000 = 1000"}
PROCEDURES = "Forward Backward Stop"


class Motor:
    def __init__(self, settings):
        frequency = int(settings.get("frequency", "1000"))
        self.forward = Wave(settings["forward"], frequency)
        self.backward = Wave(settings["backward"], frequency)

    def do(self, procedure, arguments):
        self.stop()  # never both inputs at once
        if procedure != "Stop":
            part = max(0, min(arguments[0], 100)) * FULL // 100
            (self.backward if procedure == "Backward" else self.forward).give(part)

    def stop(self):
        self.forward.give(0)
        self.backward.give(0)


make = Motor
