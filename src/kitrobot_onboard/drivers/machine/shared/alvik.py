# An Arduino Alvik: its motors, lights and sensors are at an STM32, which the board (a Nano ESP32) talks to over a UART.
#
# Both sides send frames: `A`, how many bytes, a code and its values, `#`, and a checksum (CRC-8 of Maxim) of code and
# values. Told are `J` the revolutions a minute of both wheels, `R` a turn on the spot in degrees, `X` `K` that its end
# was heard, `L` the lights, `S` both servos, `B` a behaviour. The STM32 sends what it measures by itself, each kind
# about every 50 ms, and `x` ten times a second: `R` once it has turned, until it hears `X`; 0 else. Nothing is waited
# for but once, when the STM32 is started anew: a frame cut by the last program would keep it from understanding the
# next ones.

import struct
import time

from machine import UART, Pin

BOOT = 5  # D2: low, or the STM32 waits for new firmware
RESET = 6  # D3: low stops the STM32
CHARGING = 7  # D4: low, or the STM32 only charges
CHECK = 13  # A6: high while the robot is switched on
TX = 43
RX = 44
BAUD = 115200
ROOM = 2048  # bytes that may wait: the STM32 sends some 700 in a tenth of a second

RESET_MS = 100
START_MS = 6000  # until its first `x`
LATE_MS = 500  # without a measure it is broken, or the line is
PAUSE_MS = 250  # when nobody listened for so long, what waits is old

FIRST = 65  # A
LAST = 35  # #
MOST = 33  # bytes of code and values
BOOTED = 0x7E  # sent while it starts, with its version
LINES, TOUCHED, COLOURS, ZONES, ACK = b"ltcfx"
SIZES = {LINES: 7, TOUCHED: 2, COLOURS: 7, ZONES: 15, ACK: 2}  # of the measures that are kept, with their code
TURNED = 82  # R

FULL_RPM = 70
ILLUMINATOR = 2  # the light for the eyes that look at the ground


def row(value):
    for _ in range(8):
        value = value >> 1 ^ 0x8C if value & 1 else value >> 1
    return value


ROWS = bytes([row(value) for value in range(256)])


def checksum(data):
    found = 0
    for value in data:
        found = ROWS[found ^ value]
    return found


def frame(code, form, *values):
    """What is sent. `form`: of the values, as `struct` has it."""
    data = struct.pack("<B" + form, ord(code), *values)
    return bytes((FIRST, len(data))) + data + bytes((LAST, checksum(data)))


class Alvik:
    """The robot, shared by all drivers.

    `seen`: when the last measure of a kind came, and its bytes. `wanted`: percent of full speed, by who wants it, of
    each wheel. `degrees`: of the turn that is not done yet, or None; `told`: whether the STM32 knows of it. `ack`: what
    it last acknowledged, None while that is not known.
    """

    def __init__(self):
        self.check = Pin(CHECK, Pin.IN, Pin.PULL_DOWN)
        self.refuse_off()
        for low in (BOOT, CHARGING):
            Pin(low, Pin.OUT).value(0)
        self.uart = UART(1, baudrate=BAUD, tx=TX, rx=RX, rxbuf=ROOM)
        self.seen = {}
        self.wanted = {}
        self.rpm = self.degrees = self.ack = None
        self.told = False
        self.lights = ILLUMINATOR
        self.angles = [0, 0]
        self.begin()

    def refuse_off(self):
        if not self.check.value():
            raise OSError("the Alvik is switched off")

    def begin(self):
        """Starts the STM32 anew and waits until it says something."""
        reset = Pin(RESET, Pin.OUT)
        reset.value(0)
        time.sleep_ms(RESET_MS)
        self.uart.read(self.uart.any())
        self.rest = b""
        reset.value(1)
        self.heard = self.since = begun = time.ticks_ms()
        while self.ack is None:
            if time.ticks_diff(time.ticks_ms(), begun) > START_MS:
                raise OSError("no answer from the Alvik")
            time.sleep_ms(5)
            self.hear()
        self.since = time.ticks_ms()
        self.greet()

    def greet(self):
        """What the STM32 does not know after a start. Its wheels stand then, until a driver wants something."""
        self.rpm = None
        self.say("L", "B", self.lights)
        self.say("B", "B", 1)  # no light for the ground while the robot is lifted

    def say(self, code, form, *values):
        self.uart.write(frame(code, form, *values))

    def hear(self):
        """Takes what has come. Never waits."""
        now = time.ticks_ms()
        data = self.rest + (self.uart.read(self.uart.any()) or b"")
        if time.ticks_diff(now, self.heard) > PAUSE_MS:
            data = b""
            self.ack = None
            self.since = now
        self.heard = now
        at = 0
        while at + 1 < len(data):
            end = at + data[at + 1] + 4
            if data[at] != FIRST or data[at + 1] > MOST:
                at += 1
            elif end > len(data):
                break
            elif data[end - 2] != LAST or checksum(data[at + 2 : end - 2]) != data[end - 1]:
                at += 1
            else:
                self.take(data[at + 2 : end - 2], now)
                at = end
        self.rest = data[at:]

    def take(self, data, now):
        if data and data[0] == BOOTED:
            self.greet()
        elif data and SIZES.get(data[0]) == len(data):
            self.seen[data[0]] = now, data
            if data[0] == ACK:
                self.ack = data[1]

    def look(self, code):
        """The last measure of a kind, its code included, or None when there is none yet. Raises OSError when it stays
        away.
        """
        self.refuse_off()
        self.hear()
        when, data = self.seen.get(code, (self.since, None))
        if min(time.ticks_diff(self.heard, when), time.ticks_diff(self.heard, self.since)) > LATE_MS:
            raise OSError("no answer from the Alvik")
        return data

    def numbers(self, code):
        """The same of a kind that has numbers."""
        data = self.look(code)
        return data and struct.unpack("<%dh" % (len(data) // 2), data[1:])

    def want(self, who, left, right):
        self.wanted[who] = left, right
        self.move()

    def move(self):
        if self.degrees is not None:
            return  # what the wheels do after the turn
        rpm = []
        for side in (0, 1):
            percent = sum([wanted[side] for wanted in self.wanted.values()])
            rpm.append(max(-100, min(percent, 100)) * FULL_RPM / 100)
        if rpm != self.rpm:
            self.refuse_off()
            self.say("J", "ff", *rpm)
            self.rpm = rpm

    def turn(self, degrees):
        """Begins a turn, counter-clockwise."""
        self.refuse_off()
        self.degrees = degrees
        self.told = False
        self.turned()

    def turned(self):
        """Whether the turn is done; nothing else moves the robot meanwhile."""
        if self.degrees is None:
            return True
        self.look(ACK)
        if self.ack == TURNED:
            self.say("X", "B", 75)  # K
            self.ack = None
            if self.told:
                self.end_turn()
                return True
        elif self.ack == 0 and not self.told:  # so that the next `R` is of this turn, and not of one before
            self.say("R", "f", self.degrees)
            self.told = True
        return False

    def end_turn(self):
        self.degrees = self.rpm = None
        self.move()

    def light(self, which, on):
        """`which`: bits of the lights. Other lights stay."""
        self.refuse_off()
        self.lights = self.lights & ~which | (which if on else 0)
        self.say("L", "B", self.lights)

    def darken(self, which):
        self.lights &= ~which
        self.say("L", "B", self.lights)

    def servo(self, which, degrees):
        """Both are told at once: the other one stays, or goes to 0 where it was not told yet."""
        self.refuse_off()
        self.angles[which] = degrees
        self.say("S", "BB", *self.angles)

    def stop(self):
        """Is said whatever was said before, and whether it is heard or not."""
        self.wanted.clear()
        self.degrees = self.rpm = self.ack = None
        self.say("J", "ff", 0, 0)
        self.say("X", "B", 75)


robots = []


def robot():
    """The robot, started when it is first asked for."""
    if not robots:
        robots.append(Alvik())
    return robots[0]
