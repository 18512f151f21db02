# Whether something is nearer than `reach`, seen by an ultrasonic range finder such as HC-SR04 (see `shared.echoes`): 1
# or 0.

from kitrobot_onboard.drivers.machine.shared.echoes import MM, SCALE, Finder

SETTINGS = {"trigger": "shared", "echo": "shared", "reach": "20..4000 = 120"}


class Near:
    def __init__(self, settings):
        self.reach = int(settings.get("reach", "120"))
        self.finder = Finder(settings["trigger"], settings["echo"], self.reach)

    def read(self):
        width = self.finder.look()
        return 1 if width is not None and width * MM < self.reach * SCALE else 0


make = Near
