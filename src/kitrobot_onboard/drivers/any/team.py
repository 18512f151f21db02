# What a robot has of its team: its host says what comes of it (docs/reference/link.md, `m`). Without one nothing does.

SETTINGS = {}
PROCEDURES = "Join Enter Meet Ask Move Take Done"


class Team:
    def do(self, procedure, arguments):
        pass

    def done(self):
        return False

    def stop(self):
        pass

    def read(self):
        return 0


def make(settings):
    return Team()
