# One of the buttons on top of an Arduino Alvik, which feel a finger (see `shared.alvik`): 1 while it is touched.

from kitrobot_onboard.drivers.machine.shared.alvik import TOUCHED, robot

SETTINGS = {"which": "any|ok|cancel|center|up|left|down|right = ok"}
NAMES = ("any", "ok", "cancel", "center", "up", "left", "down", "right")


class Key:
    def __init__(self, settings):
        self.robot = robot()
        self.bit = NAMES.index(settings.get("which", "ok"))

    def read(self):
        data = self.robot.look(TOUCHED)
        return data[1] >> self.bit & 1 if data else 0


make = Key
