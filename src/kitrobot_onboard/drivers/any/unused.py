# The place of an actuator that a program never gives a command: its device is left alone.

SETTINGS = {}
PROCEDURES = ""


class Unused:
    def stop(self):
        pass


def make(settings):
    return Unused()
