# An Arduino Alvik on a road, which is a dark line: the wheel on the side whose eye sees it goes slower (see
# `shared.alvik`).

from kitrobot_onboard.drivers.machine.alvik_line import Line
from kitrobot_onboard.drivers.machine.shared.alvik import robot

SETTINGS = {"threshold": "1..1023 = 512", "steer": "1..100 = 60"}
PROCEDURES = "Advance Reverse Stop"


class Road:
    def __init__(self, settings):
        self.robot = robot()
        self.steer = int(settings.get("steer", "60"))
        threshold = settings.get("threshold", "512")
        self.eyes = [Line({"eye": eye, "threshold": threshold}) for eye in ("left", "right")]
        self.speed = 0

    def do(self, procedure, arguments):
        self.speed = 0
        if procedure == "Advance":
            self.speed = arguments[0]
        elif procedure == "Reverse":
            self.speed = -arguments[0]
        self.steer_on()

    def tend(self):
        """Is called at each trip of the loop."""
        if self.speed:
            self.steer_on()
        else:
            self.robot.hear()

    def steer_on(self):
        speeds = [self.speed, self.speed]
        if self.speed > 0:  # backward it cannot see where it goes
            for side in (0, 1):
                if self.eyes[side].read():
                    speeds[side] -= self.speed * self.steer // 100
        self.robot.want("drive", speeds[0], speeds[1])

    def stop(self):
        self.speed = 0
        self.robot.stop()


make = Road
