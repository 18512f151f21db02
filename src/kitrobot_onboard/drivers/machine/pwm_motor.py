# A motor with two inputs, one for each direction, behind a driver such as DRV8833, TB6612 or L298N.

from kitrobot_onboard.drivers.machine.pins import FULL, Wave

SETTINGS = {"forward": "pin", "backward": "pin", "frequency": "10..100000 = 1000"}
WAVES = {"forward": "frequency", "backward": "frequency"}
PROCEDURES = "Forward Backward Stop"


class Motor:
    def __init__(self, settings):
        frequency = int(settings.get("frequency", "1000"))
        self.forward = Wave(settings["forward"], frequency)
        self.backward = Wave(settings["backward"], frequency)

    def do(self, procedure, arguments):
        if procedure == "Stop":
            self.stop()
        else:
            turns, rests = self.forward, self.backward
            if procedure == "Backward":
                turns, rests = rests, turns
            rests.give(0)  # never both inputs at once; the other is not touched, or it would lose power each time
            turns.give(max(0, min(arguments[0], 100)) * FULL // 100)

    def stop(self):
        self.forward.give(0)
        self.backward.give(0)


make = Motor
