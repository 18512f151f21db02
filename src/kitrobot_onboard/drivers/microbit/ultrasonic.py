# An ultrasonic range finder such as HC-SR04: the sensor's least value is touching, its largest is `reach` or more; with
# `near` its largest is nearer than `reach`. It is asked every 60 ms at most. One that begins no answer five times is
# not plugged in.

import microbit
from machine import time_pulse_us
from utime import sleep_us

SETTINGS = {"trigger": "shared", "echo": "shared", "reach": "20..4000 = 1000", "near": "yes|no = no"}


class Finder:
    def __init__(self, settings):
        self.trigger = getattr(microbit, "pin" + settings["trigger"])
        self.echo = getattr(microbit, "pin" + settings["echo"])
        self.reach = int(settings.get("reach", "1000"))
        self.least = int(settings.get("min", "0"))
        self.span = int(settings.get("max", "100")) - self.least
        self.near = settings.get("near") == "yes"
        self.seen = self.least if self.near else self.least + self.span
        self.due = self.silent = 0
        self.trigger.write_digital(0)
        self.echo.read_digital()

    def read(self):
        if microbit.running_time() >= self.due:
            self.due = microbit.running_time() + 60
            self.trigger.write_digital(1)
            sleep_us(10)
            self.trigger.write_digital(0)
            width = time_pulse_us(self.echo, 1, 1000 + self.reach * 6)
            self.silent = self.silent + 1 if width == -2 else 0
            if self.silent > 4:
                self.silent = 0
                raise OSError("no answer: not plugged in?")
            part = self.span
            if width >= 0:
                part = min(part, width * 343 * self.span // (2000 * self.reach))
            self.seen = self.least + (part < self.span if self.near else part)
        return self.seen


make = Finder
