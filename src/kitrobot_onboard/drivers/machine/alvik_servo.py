# A door that a servo moves, at one of the two connectors for servos of an Arduino Alvik (see `shared.alvik`). Where it
# is nobody knows; it is there after `time` from one end to the other. The STM32 cannot leave a servo without force:
# when it is stopped, it goes to where it was told last, and stays.

import time

from kitrobot_onboard.drivers.machine.shared.alvik import robot

SETTINGS = {"servo": "a|b = a", "open": "0..180 = 90", "closed": "0..180 = 0", "time": "1..60000 = 1000"}
PROCEDURES = "Open Close"


class Servo:
    def __init__(self, settings):
        self.robot = robot()
        self.which = "ab".index(settings.get("servo", "a"))
        self.angles = {"Open": int(settings.get("open", "90")), "Close": int(settings.get("closed", "0"))}
        self.needed = int(settings.get("time", "1000"))
        self.begun = None

    def do(self, procedure, arguments):
        self.robot.servo(self.which, self.angles[procedure])
        self.begun = time.ticks_ms()

    def done(self):
        return self.begun is None or time.ticks_diff(time.ticks_ms(), self.begun) >= self.needed

    def tend(self):
        """Is called at each trip of the loop: what the robot says does not pile up."""
        self.robot.hear()

    def stop(self):
        self.begun = None


make = Servo
