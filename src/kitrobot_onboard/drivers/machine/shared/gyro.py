# How far a robot has turned, from the gyroscope of an LSM6DSO (ST): its rate around the upright axis, summed up at each
# tick. What it reads while the robot stands, when it is made, is its zero.

import time

from kitrobot_onboard.drivers.machine.shared.buses import bus_of

WHO = 0x0F
CTRL2_G = 0x11
CTRL3_C = 0x12
OUTZ_L_G = 0x26
DPS500_208HZ = 0x54
BLOCK_AND_COUNT = 0x44
SCALE = 35  # thousandths of a degree a second for each bit, doubled: 17.5 at 500 degrees a second


class Gyro:
    def __init__(self, settings):
        self.bus = bus_of(settings)
        self.address = int(settings.get("address", "107"))
        self.bus.readfrom_mem(self.address, WHO, 1)  # raises when it is not plugged in
        self.write(CTRL3_C, BLOCK_AND_COUNT)
        self.write(CTRL2_G, DPS500_208HZ)
        time.sleep_ms(20)
        self.zero = sum([self.rate() for _ in range(8)]) // 8
        self.sum = 0
        self.since = time.ticks_us()

    def write(self, register, value):
        self.bus.writeto_mem(self.address, register, bytes((value,)))

    def rate(self):
        low, high = self.bus.readfrom_mem(self.address, OUTZ_L_G, 2)
        value = low + 256 * high
        return value - 65536 if value > 32767 else value

    def begin(self, speed):
        self.sum = 0
        self.since = time.ticks_us()

    def turned(self):
        """In thousandths of a degree."""
        now = time.ticks_us()
        self.sum += (self.rate() - self.zero) * time.ticks_diff(now, self.since) // 1000
        self.since = now
        return self.sum * SCALE // 2000
