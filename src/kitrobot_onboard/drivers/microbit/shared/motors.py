# The two motors of a micro:bit's kit, behind a chip on its I2C bus, or (`kit="pins"`) at a motor board that is wired to
# pins: with `forward` and `backward` (DRV8833, L9110), or with `power` too (TB6612, L298N). `drive`, `turn` and `wheel`
# each say what they want, and the wheels turn by the sum; `tend` tells the chip what has changed. On the micro:bit of
# 2016 nothing here may call a function that calls another one: its stack would end (docs/reference/boards.md). What is
# not of the kit that a program is sent to, and what it does not call, is left out of what is sent
# (kitrobot.deploy.minification.tree_shaking).

from microbit import i2c, running_time

wanted = [0, 0, 0, 0, 1]  # percent: forward, counter-clockwise, each wheel by itself; whether that is news
told = [None, None]  # the percent of each wheel; then, at pins, those of each


def write(kit, side, percent):
    """Tells one motor."""
    part = abs(percent)
    if kit == "maqueen":
        i2c.write(16, bytes((2 * side, percent < 0, part * 255 // 100)))
    if kit == "cutebot":
        i2c.write(16, bytes((1 + side, 1 if percent < 0 else 2, part, 0)))
    if kit == "move":
        at = 2 if side else 4
        ahead = (percent > 0) == (side == 1)
        i2c.write(98, bytes((at + (not ahead), 0)))
        i2c.write(98, bytes((at + ahead, part * 255 // 100)))
    if kit == "pins":
        pins = told[2 + side]
        back = percent < 0
        pins[not back].write_digital(0)  # never both inputs at once
        if len(pins) > 2:
            pins[back].write_digital(1 if part else 0)
            back = 2
        pins[back].write_analog(part * 1023 // 100)


class Motors:
    def __init__(self, settings, at):
        self.kit = kit = settings["kit"]
        self.at = at
        self.rate = int(settings.get("rate", settings.get("speed", "180" if at else "400")))
        self.goal = None
        if kit == "move":
            for pair in (b"\0\0", b"\1\4", b"\x08\xaa"):
                i2c.write(98, pair)
        if kit == "pins":
            if len(told) == 2:
                import microbit

                for side in ("left", "right"):
                    names = [settings.get(side + end) for end in ("-forward", "-backward", "-power")]
                    told.append([getattr(microbit, "pin" + name) for name in names if name])

    def do(self, procedure, arguments):
        self.goal = None
        percent = arguments[-1] if arguments else 0
        if procedure in ("Reverse", "Backward"):
            percent = -percent
        if procedure == "AbsoluteTurn":
            self.goal = arguments[0] * 360
        if procedure in ("LeftBy", "RightBy", "DriveBy", "BackBy"):
            self.goal = abs(percent) * (100 if self.at else 1000)
            percent = 50 if (percent > 0) == (procedure in ("LeftBy", "DriveBy")) else -50
        if self.goal is not None:
            self.since = running_time()
        wanted[self.at] = percent
        wanted[4] = 1

    def done(self):
        # In hundredths of a degree or a millimetre: time, full rate, and speed in percent.
        if (
            self.goal is not None
            and (running_time() - self.since) * self.rate * abs(wanted[self.at]) // 1000 >= self.goal
        ):
            self.goal = None
            wanted[self.at] = 0
            wanted[4] = 1
        return self.goal is None

    def tend(self):
        if not wanted[4]:
            return
        for side in (0, 1):
            percent = wanted[0] + (wanted[1] if side else -wanted[1]) + wanted[2 + side]
            if told[side] != percent:
                write(self.kit, side, max(-100, min(percent, 100)))
                told[side] = percent
        wanted[4] = 0  # not before: what a chip did not take is told again

    def stop(self):
        self.goal = None
        for at in range(4):
            wanted[at] = 0
        wanted[4] = 1
        for side in (0, 1):
            told[side] = None  # stands still, whatever was told before
            write(self.kit, side, 0)
