# Whether something is nearer than `reach`, seen by the range finder of an Arduino Alvik in one of its three zones ahead
# (see `shared.alvik`): 1 or 0.

from kitrobot_onboard.drivers.machine.shared.alvik import ZONES, robot

SETTINGS = {"reach": "20..4000 = 120"}


class Near:
    def __init__(self, settings):
        self.robot = robot()
        self.reach = int(settings.get("reach", "120"))

    def read(self):
        zones = self.robot.numbers(ZONES)
        return 1 if zones and min(zones[1:4]) < self.reach else 0


make = Near
