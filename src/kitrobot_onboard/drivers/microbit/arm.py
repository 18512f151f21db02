# An arm that a servo at a pin moves: to the box and back, half of `time` each way. All of it is here: on the micro:bit
# of 2016 the stack ends in a driver that brings helpers along.

import microbit

SETTINGS = {
    "pin": "pin",
    "rest": "0..180 = 0",
    "load": "0..180 = 90",
    "unload": "0..180 = 90",
    "time": "100..60000 = 2000",
}
PROCEDURES = "Load Unload"


class Arm:
    def __init__(self, settings):
        self.pin = getattr(microbit, "pin" + settings["pin"])
        self.rest = int(settings.get("rest", "0"))
        self.load = int(settings.get("load", "90"))
        self.unload = int(settings.get("unload", "90"))
        self.half = int(settings.get("time", "2000")) // 2
        self.back = self.until = 0
        self.stop()

    def do(self, procedure, arguments):
        angle = self.load if procedure == "Load" else self.unload
        self.pin.set_analog_period(20)
        self.pin.write_analog(26 + angle * 102 // 180)
        self.back = microbit.running_time() + self.half
        self.until = self.back + self.half

    def done(self):
        now = microbit.running_time()
        if self.back and now >= self.back:
            self.back = 0
            self.pin.set_analog_period(20)
            self.pin.write_analog(26 + self.rest * 102 // 180)
        return now >= self.until

    def stop(self):
        self.pin.write_digital(0)  # without pulses a servo has no force
        self.back = self.until = 0


make = Arm
