# An Arduino Alvik that turns on the spot, counter-clockwise (see `shared.alvik`). A turn by an angle its STM32 does as
# fast as it finds right, whatever the speed, and says when it is done; it goes before what other drivers want. `rate`:
# how many degrees it really turns when it is told 180.

from kitrobot_onboard.drivers.machine.shared.alvik import robot

SETTINGS = {"rate": "10..2000 = 180"}
PROCEDURES = "AbsoluteTurn Turn LeftBy RightBy Stop"


class Turn:
    def __init__(self, settings):
        self.robot = robot()
        self.rate = int(settings.get("rate", "180"))
        self.stands = False  # told to turn without speed, which never ends

    def do(self, procedure, arguments):
        self.stands = False
        if self.robot.degrees is not None:
            self.robot.end_turn()
        if procedure == "AbsoluteTurn":
            self.robot.want("turn", 0, 0)
            self.stands = arguments[0] > 0 and arguments[-1] <= 0
            if arguments[0] > 0 and not self.stands:
                self.robot.turn(arguments[0] * 3.6 * 180 / self.rate)  # from percent of a full turn
        elif procedure in ("LeftBy", "RightBy"):
            self.robot.want("turn", 0, 0)
            if arguments[0]:
                degrees = arguments[0] if procedure == "LeftBy" else -arguments[0]
                self.robot.turn(degrees * 180 / self.rate)
        else:
            speed = 0 if procedure == "Stop" else arguments[-1]
            self.robot.want("turn", -speed, speed)

    def done(self):
        return not self.stands and self.robot.turned()

    def tend(self):
        """Is called at each trip of the loop: what the robot says does not pile up."""
        self.robot.hear()

    def stop(self):
        self.stands = False
        self.robot.stop()


make = Turn
