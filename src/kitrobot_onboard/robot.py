# The loop of a robot: in each tick sample the inputs, run the program, hand its commands to the devices; in the gap
# until the next one listen to the link and tell what changed. Whatever a driver does wrong stops the devices, never
# the link.
#
# A port is what a platform adds (see `ports`): ticks(), diff(a, b) and add(a, b) of milliseconds that may wrap;
# read(ms), which waits at most so long for bytes; write(bytes); free() bytes of memory; identify(on); and BYTE_US, how
# long a byte holds us up when it is written.

import struct

from kitrobot_onboard.answers import answer
from kitrobot_onboard.interpreter import tick
from kitrobot_onboard.link import LONGEST, unwrap
from kitrobot_onboard.report import tell

HOLD_MS = 800  # a held run ends when no whole frame came for so long
SHOW_MS = 2000
GAP_MS = 50  # the longest wait when no tick is due

# What state a robot is in: 0 no program, 1 ready, 2 running, 3 ended, 4 fault.


class Robot:
    def __init__(self, port, names, generation):
        self.port = port
        self.names = names  # package and program, as text for H
        self.generation = generation
        self.state = 0
        self.gone = False  # whether to leave to the prompt
        self.fault = 0, 65535, 0, ""  # number, instruction, tick, text
        self.ticks = self.late = 0
        self.cells = None  # of the program that was loaded, as tick wants it; with code, threads, pars and out
        self.actuators = []  # (driver, done cell or 0) for each
        self.procedures = []  # the name of each command
        self.kinds = []  # for each command, twice the number of its arguments, and 1 more when it completes later
        self.limits = []  # for each, how many ms what takes it longer may take
        self.since = []  # for each, when that began, or None
        self.sensors = []  # (driver, cell, least, most)
        self.seen = []
        self.forced = {}
        self.at = None  # the device in hand: number of an actuator, or -1 - number of a sensor
        self.steps = True  # step by step: no tick is due
        self.held = False
        self.period = 0  # between two news, in ms; 0: nobody watches
        self.rest = b""  # what was heard of a frame that is not whole yet
        self.last = self.reply = None  # kind and number of the last request, and its answer
        self.sent = ()  # what was told last: where each slot stands, each cell's value
        self.next = 0  # which of those to look at next
        self.news = b""  # records that wait to be sent
        self.shown = None  # since when it shows itself
        self.due = self.heard = self.told = port.ticks()

    def run(self):
        """Goes on until somebody asks for the prompt."""
        try:
            while not self.gone:
                try:
                    self.turn()
                except MemoryError:
                    self.fail(3, 65535, "")
                except OSError as error:
                    self.fail(4, 65535, repr(error))
                except KeyboardInterrupt:
                    break
        finally:
            self.stop()

    def take(self, name, loaded):
        """Takes a program that was loaded from a file, and its devices, which `equip` made."""
        fields, found, self.offset = loaded[:3]
        self.file = name
        self.inputs = fields[6]
        self.visible = 1 + fields[6] + fields[7]
        self.tick_ms = fields[4]
        self.code, self.cells, self.threads, self.pars, self.out = found
        self.state = 1

    def turn(self):
        """One tick, when it is due, and the gap after it."""
        port = self.port
        left = GAP_MS
        if self.state == 2 and not self.steps:
            left = port.diff(self.due, port.ticks())
            if left <= 0:
                self.due = port.add(self.due, self.tick_ms)
                self.react()
                left = port.diff(self.due, port.ticks())
                if left < 0:
                    self.due = port.ticks()
                    left = 0
                    if self.late < 65535:
                        self.late += 1
        if self.period:
            tell(self)
            if left < GAP_MS:
                left = max(0, port.diff(self.due, port.ticks()))
        self.hear(port.read(left))
        if self.held and self.state == 2 and port.diff(port.ticks(), self.heard) > HOLD_MS:
            self.fail(6, 65535, "")
        if self.shown is not None and port.diff(port.ticks(), self.shown) > SHOW_MS:
            self.shown = None
            port.identify(False)

    # ---- the program --------------------------------------------------------------------------------------

    def react(self):
        """One tick of the program, with the inputs before and the commands after it."""
        instruction = 65535
        try:
            instruction = self.sample()
            if instruction == 65535:
                self.at = None
                tick(self.code, self.cells, self.threads, self.pars, self.out, self.seen)
                self.ticks += 1
                out = self.out
                for n in range(len(self.actuators)):
                    o = n * self.pars[3]
                    if out[o]:
                        instruction = out[o + 1]
                        self.command(n, o)
                if self.threads[0] < 0:
                    self.state = 3
        except MemoryError:
            self.fail(3, instruction, "")
        except Exception as error:
            n = self.at
            if instruction == 65535 and n is not None and n >= 0 and self.since[n] is not None:
                instruction = self.since[n][1]
            self.fail(1, instruction, self.device() + repr(error))

    def sample(self):
        """Reads every input once. Returns the instruction of a device that was not done in its time, 65535 for none."""
        cells = self.cells
        forced = self.forced
        n = -1
        for driver, cell, least, most in self.sensors:
            self.at = n
            n -= 1
            x = forced[cell] if cell in forced else driver.read()
            cells[cell] = least if x < least else most if x > most else x
        n = 0
        for driver, cell in self.actuators:
            if cell:
                self.at = n
                since = self.since[n]
                if since is not None:
                    if driver.done():
                        self.since[n] = since = None
                    elif not self.steps and self.port.diff(self.port.ticks(), since[0]) > self.limits[n]:
                        self.fail(2, since[1], self.device() + "not done")
                        return since[1]
                cells[cell] = (1 if forced[cell] else 0) if cell in forced else 1 if since is None else 0
            n += 1
        return 65535

    def command(self, n, o):
        """Hands an actuator its command."""
        out = self.out
        self.at = n
        kind = self.kinds[out[o + 2]]
        self.since[n] = (self.port.ticks(), out[o + 1]) if kind & 1 else None
        self.actuators[n][0].do(self.procedures[out[o + 2]], out[o + 3 : o + 3 + (kind >> 1)])

    def device(self):
        """The device in hand, as the texts of faults name it."""
        n = self.at
        return "" if n is None else "s%d " % (-1 - n) if n < 0 else "a%d " % n

    def begin(self, steps):
        """Makes ready for the first tick. Returns whether there is a program."""
        if self.cells is None:
            return False
        self.stop()
        self.rewind()
        self.fault = 0, 65535, 0, ""
        self.ticks = self.late = 0
        self.steps = steps
        self.state = 2
        self.due = self.port.ticks()
        return True

    def rewind(self):
        """Puts the arrays back to the program's first instruction."""
        file = open(self.file, "rb")
        left = self.offset
        while left:
            left -= len(file.read(min(left, 32)))
        for i in range(len(self.cells)):
            self.cells[i] = struct.unpack("<i", file.read(4))[0]
        file.close()
        for i in range(0, len(self.threads), 2):
            self.threads[i] = -1
            self.threads[i + 1] = 0
        pars = self.pars
        self.threads[0] = pars[5]
        at = 4 + 4 * pars[0]
        for i in range(pars[1]):
            pars[at + 5 * i] = 0
        at += 5 * pars[1]
        for i in range(pars[2]):
            pars[at + 3 * i] = 0

    def stop(self):
        """Stops every device, whatever one of them says to it, and the program."""
        failed = None
        self.held = False
        n = 0
        for driver, _ in self.actuators:
            self.since[n] = None
            try:
                driver.stop()
            except Exception as error:
                if failed is None:
                    self.at = n
                    failed = self.device() + repr(error)
            n += 1
        if self.state:
            self.state = 1
        return failed

    def fail(self, number, instruction, text):
        """Stops every device and says why."""
        tick = self.ticks
        self.stop()
        self.state = 4
        self.fault = number, instruction, tick, text[:60]
        self.port.write(answer(self, "l", b"", 0))

    # ---- the link -----------------------------------------------------------------------------------------

    def hear(self, data):
        """Takes what came over the link."""
        if not data:
            return
        data = self.rest + data
        if b"\x03\x03" in data or b"\r\x03" in data:
            self.gone = True
            return
        while True:
            end = data.find(b"~")
            if end < 0:
                break
            if 4 <= end < LONGEST:
                found = unwrap(data[:end])
                if found and found[0] >= "a" and found[1]:
                    self.obey(found)
            data = data[end + 1 :]
        self.rest = data[-LONGEST:]

    def obey(self, found):
        """Answers a request; one that was heard already does nothing again."""
        kind, number, data = found
        self.heard = self.port.ticks()
        if self.last != (kind, number) or kind in "hlp":
            self.last = None
            self.reply = answer(self, kind, data, number)
            self.last = kind, number
        self.port.write(self.reply)
