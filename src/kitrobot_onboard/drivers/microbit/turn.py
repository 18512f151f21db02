# A kit of a micro:bit that turns on the spot, counter-clockwise, by the clock: at full speed `rate` degrees a second.

from microbit import running_time

from kitrobot_onboard.drivers.microbit.shared.base import begin, halt, move, wanted

SETTINGS = {"kit": "maqueen|cutebot|move", "rate": "10..2000 = 180"}
PROCEDURES = "AbsoluteTurn Turn Stop"


class Turn:
    def __init__(self, settings):
        self.kit = settings["kit"]
        self.rate = int(settings.get("rate", "180"))
        self.goal = None
        begin(self.kit)

    def do(self, procedure, arguments):
        self.goal = None
        wanted[1] = 0
        if procedure != "Stop":
            wanted[1] = arguments[-1]
        if procedure == "AbsoluteTurn":
            self.goal = arguments[0] * 360
            self.since = running_time()
        move(self.kit)

    def done(self):
        # In hundredths of a degree: percent of a full turn, and speed in percent.
        if self.goal is not None and (running_time() - self.since) * self.rate * wanted[1] // 1000 >= self.goal:
            self.goal = None
            wanted[1] = 0
            move(self.kit)
        return self.goal is None

    def stop(self):
        self.goal = None
        halt(self.kit)


make = Turn
