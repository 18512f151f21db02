# An Arduino Alvik that drives straight on (see `shared.alvik`). A distance it drives by the clock, at half speed:
# `speed` is how fast it is at full speed, in millimetres a second.

import time

from kitrobot_onboard.drivers.machine.shared.alvik import robot

SETTINGS = {"speed": "10..5000 = 125"}
PROCEDURES = "Advance Reverse DriveBy BackBy Stop"


class Drive:
    def __init__(self, settings):
        self.robot = robot()
        self.full = int(settings.get("speed", "125"))
        self.needed = None  # milliseconds that a distance takes

    def do(self, procedure, arguments):
        speed = 0
        self.needed = None
        if procedure == "Advance":
            speed = arguments[0]
        elif procedure == "Reverse":
            speed = -arguments[0]
        elif procedure in ("DriveBy", "BackBy"):
            distance = arguments[0] if procedure == "DriveBy" else -arguments[0]
            speed = 50 if distance > 0 else -50
            self.needed = abs(distance) * 20000 // self.full
            self.since = time.ticks_ms()
        self.robot.want("drive", speed, speed)

    def done(self):
        if self.needed is not None and time.ticks_diff(time.ticks_ms(), self.since) >= self.needed:
            self.do("Stop", ())
        return self.needed is None

    def tend(self):
        """Is called at each trip of the loop: what the robot says does not pile up."""
        self.robot.hear()

    def stop(self):
        self.needed = None
        self.robot.stop()


make = Drive
