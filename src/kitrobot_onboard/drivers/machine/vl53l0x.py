# A time-of-flight range finder VL53L0X (ST) with the settings that it has when the power comes on: good to about a
# metre. The sensor's least value is touching, its largest is `reach` or more, or nothing seen. It measures by itself,
# which takes some 30 ms; it is looked at in each tick, and never waited for.

import time

from kitrobot_onboard.drivers.machine.shared.buses import bus_of

SETTINGS = {
    "sda": "shared",
    "scl": "shared",
    "bus": "0..1 = 0",
    "address": "8..119 = 41",
    "reach": "20..2000 = 1000",
}

START = 0x00
CLEAR = 0x0B
READY = 0x13
RESULT = 0x14
MODEL = 0xC0
ITS_MODEL = 0xEE
VALID = 11
LATE_MS = 500


class Range:
    def __init__(self, settings):
        self.bus = bus_of(settings)
        self.address = int(settings.get("address", "41"))
        self.reach = int(settings.get("reach", "1000"))
        self.least = int(settings.get("min", "0"))
        self.most = int(settings.get("max", "100"))
        self.seen = self.most
        if self.bus.readfrom_mem(self.address, MODEL, 1)[0] != ITS_MODEL:
            raise OSError("no VL53L0X at this address")
        self.begin()

    def begin(self):
        self.bus.writeto_mem(self.address, CLEAR, b"\1")
        self.bus.writeto_mem(self.address, START, b"\1")
        self.begun = time.ticks_ms()

    def read(self):
        if self.bus.readfrom_mem(self.address, READY, 1)[0] & 7:
            data = self.bus.readfrom_mem(self.address, RESULT, 12)
            self.seen = self.most
            if data[0] >> 3 & 15 == VALID:
                span = self.most - self.least
                way = data[10] * 256 + data[11]
                self.seen = min(self.most, self.least + (way * span + self.reach // 2) // self.reach)
            self.begin()
        elif time.ticks_diff(time.ticks_ms(), self.begun) > LATE_MS:
            self.begin()
            raise OSError("no answer: not plugged in?")
        return self.seen


make = Range
