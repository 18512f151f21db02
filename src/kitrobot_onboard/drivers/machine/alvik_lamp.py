# The lights of an Arduino Alvik, one on each side (see `shared.alvik`).

from kitrobot_onboard.drivers.machine.shared.alvik import robot

SETTINGS = {
    "light": "left|right|both = both",
    "colour": "white|red|green|blue|yellow|magenta|cyan = white",
}
PROCEDURES = "LightOn LightOff"

# Bits of the left one: 4 red, 8 green, 16 blue; the right one's are eight times as large.
PARTS = {"white": 28, "red": 4, "green": 8, "blue": 16, "yellow": 12, "magenta": 20, "cyan": 24}
SIDES = {"left": 1, "right": 8, "both": 9}


class Lamp:
    def __init__(self, settings):
        self.robot = robot()
        self.which = PARTS[settings.get("colour", "white")] * SIDES[settings.get("light", "both")]
        self.stop()

    def do(self, procedure, arguments):
        self.robot.light(self.which, procedure == "LightOn")

    def tend(self):
        """Is called at each trip of the loop: what the robot says does not pile up."""
        self.robot.hear()

    def stop(self):
        self.robot.darken(self.which)


make = Lamp
