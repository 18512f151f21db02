# One wheel of an Arduino Alvik (see `shared.alvik`).

from kitrobot_onboard.drivers.machine.shared.alvik import robot

SETTINGS = {"side": "left|right"}
PROCEDURES = "Forward Backward Stop"


class Wheel:
    def __init__(self, settings):
        self.robot = robot()
        self.side = settings["side"]

    def do(self, procedure, arguments):
        speed = 0
        if procedure == "Forward":
            speed = arguments[0]
        elif procedure == "Backward":
            speed = -arguments[0]
        if self.side == "left":
            self.robot.want("left", speed, 0)
        else:
            self.robot.want("right", 0, speed)

    def tend(self):
        """Is called at each trip of the loop: what the robot says does not pile up."""
        self.robot.hear()

    def stop(self):
        self.robot.stop()


make = Wheel
