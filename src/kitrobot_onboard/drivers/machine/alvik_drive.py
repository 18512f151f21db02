# An Arduino Alvik that drives straight on (see `shared.alvik`).

from kitrobot_onboard.drivers.machine.shared.alvik import robot

SETTINGS = {}
PROCEDURES = "Advance Reverse Stop"


class Drive:
    def __init__(self, settings):
        self.robot = robot()

    def do(self, procedure, arguments):
        speed = 0
        if procedure == "Advance":
            speed = arguments[0]
        elif procedure == "Reverse":
            speed = -arguments[0]
        self.robot.want("drive", speed, speed)

    def tend(self):
        """Is called at each trip of the loop: what the robot says does not pile up."""
        self.robot.hear()

    def stop(self):
        self.robot.stop()


make = Drive
