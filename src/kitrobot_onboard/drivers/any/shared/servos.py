# What a servo moves. `wave` is the pin it is at: `angle(degrees)` moves it, `give(0)` takes the force away. Where it is
# nobody knows; it is there after a time. `clock` has ticks_ms and ticks_diff.


class Servo:
    """Goes to the angle of a procedure, in `needed` ms at most; one that has none changes nothing."""

    def __init__(self, wave, angles, needed, clock):
        self.wave = wave
        self.angles = angles
        self.needed = needed
        self.clock = clock
        self.begun = None

    def do(self, procedure, arguments):
        if procedure in self.angles:
            self.wave.angle(self.angles[procedure])
            self.begun = self.clock.ticks_ms()

    def done(self):
        return self.begun is None or self.clock.ticks_diff(self.clock.ticks_ms(), self.begun) >= self.needed

    def stop(self):
        self.wave.give(0)  # without pulses a servo has no force
        self.begun = None


def door(settings, wave, clock):
    angles = {"Open": int(settings.get("open", "90")), "Close": int(settings.get("closed", "0"))}
    return Servo(wave, angles, int(settings.get("time", "1000")), clock)


class Arm:
    """Goes to the box and back, half of `time` each way."""

    def __init__(self, settings, wave, clock):
        self.wave = wave
        self.clock = clock
        self.rest = int(settings.get("rest", "0"))
        self.reach = {"Load": int(settings.get("load", "90")), "Unload": int(settings.get("unload", "90"))}
        self.half = int(settings.get("time", "2000")) // 2
        self.begun = None
        self.returns = False

    def do(self, procedure, arguments):
        self.wave.angle(self.reach[procedure])
        self.begun = self.clock.ticks_ms()
        self.returns = False

    def done(self):
        if self.begun is not None:
            gone = self.clock.ticks_diff(self.clock.ticks_ms(), self.begun)
            if not self.returns and gone >= self.half:
                self.wave.angle(self.rest)
                self.returns = True
            if gone >= 2 * self.half:
                self.begun = None
        return self.begun is None

    def stop(self):
        self.wave.give(0)  # without pulses a servo has no force
        self.begun = None
