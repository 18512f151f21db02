# Motors behind a chip on an I2C bus: `motors` names the kind of chip, `sda` and `scl` its bus, `motors-address` it.
#
# A kind of chip is a class here and a word in KINDS. It has `motor(settings, side)`, which gives what turns one
# motor with `turn(part, back)` (`part`: 0 to FULL), and `stop()`, which lets all its motors stand still, also one that
# lost its power and is back. Whatever it does not answer to is an OSError, and so a fault of the part. In the drivers
# `drive`, `turn`, `wheel` and `road` its settings are declared, with `where motors=NAME`.
#
# A chip goes on doing what it was told when the board loses its power or its program; so both get theirs together.

import time

from kitrobot_onboard.drivers.machine.pins import FULL
from kitrobot_onboard.drivers.machine.shared.bridges import Bridge
from kitrobot_onboard.drivers.machine.shared.buses import bus_of

MODE1 = 0x00
MODE2 = 0x01
FIRST = 0x06  # of the four registers of channel 0: when it goes on and when off, of 4096 steps
ALL_OFF = 0xFD
PRE_SCALE = 0xFE
SLEEP = 0x30  # with AUTO, as every mode here
AUTO = 0x20  # counts the register up while it is written
TOTEM_POLE = 0x04
ALWAYS = 0x10  # in the upper byte of on or off
STEPS = 4096
CLOCK_HZ = 25000000
CHANNELS = 16


class Channel:
    """An output of a PCA9685: a square wave or a level, told only when it changes."""

    def __init__(self, chip, number):
        self.chip = chip
        self.number = number

    def give(self, part):
        """`part`: 0 to FULL."""
        told = self.chip.told
        if told[self.number] == part:
            return
        told[self.number] = None  # until it has answered
        steps = part * STEPS // FULL
        if steps == 0:
            data = bytes((0, 0, 0, ALWAYS))
        elif steps == STEPS:
            data = bytes((0, ALWAYS, 0, 0))
        else:
            data = bytes((0, 0, steps & 255, steps >> 8))
        self.chip.write(FIRST + 4 * self.number, data)
        told[self.number] = part

    def value(self, level):
        self.give(FULL if level else 0)


class Pca9685:
    """16 channels with square waves of one frequency (NXP), each wired to an input of a bridge such as TB6612."""

    usual_address = 64

    def __init__(self, settings, address):
        self.bus = bus_of(settings)
        self.address = address
        frequency = int(settings.get("frequency", "1000"))
        self.scale = (CLOCK_HZ // STEPS + frequency // 2) // frequency - 1
        self.stop()

    def motor(self, settings, side):
        return Bridge(settings, side, self.channel, self.channel)

    def channel(self, name, frequency=0):
        return Channel(self, int(name))

    def stop(self):
        """All channels off with one message; then it is set up, as a chip is that just got its power."""
        self.told = [None] * CHANNELS
        for register, value in (
            (ALL_OFF, ALWAYS),
            (MODE1, SLEEP),  # only asleep it takes the frequency
            (PRE_SCALE, self.scale),
            (MODE2, TOTEM_POLE),
            (MODE1, AUTO),
        ):
            self.write(register, bytes((value,)))
        time.sleep_us(500)  # until its clock goes
        self.told = [0] * CHANNELS

    def write(self, register, data):
        try:
            self.bus.writeto_mem(self.address, register, data)
        except OSError:
            try:
                self.bus.writeto_mem(self.address, register, data)  # motors that start disturb a bus
            except OSError:
                raise OSError("no answer at address " + str(self.address) + ": not plugged in?")


KINDS = {"pca9685": Pca9685}
chips = {}


def chip_of(settings):
    """The chip at this bus and address: the same for all drivers that name it."""
    kind = KINDS[settings["motors"]]
    address = int(settings.get("motors-address", kind.usual_address))
    key = settings["sda"], settings["scl"], address
    if key not in chips:
        chips[key] = kind(settings, address)
    return chips[key]
