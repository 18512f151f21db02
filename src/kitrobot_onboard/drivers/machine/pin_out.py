# A pin for whatever is wired to it: on or off, a part of full power, the angle of a servo.

from machine import Pin

from kitrobot_onboard.drivers.machine.pins import FULL, SERVO_HZ, Wave, pin

SETTINGS = {"pin": "pin"}
PROCEDURES = "Write Analog Servo"


class Out:
    def __init__(self, settings):
        self.name = settings["pin"]
        self.wave = None
        self.frequency = 0
        self.plain = pin(self.name, Pin.OUT)
        self.plain.value(0)

    def do(self, procedure, arguments):
        value = arguments[0]
        if procedure == "Write":
            self.write(1 if value else 0)
        elif procedure == "Servo":
            self.waved(SERVO_HZ).angle(max(0, min(value, 180)))
        else:
            self.waved(1000).give(max(0, min(value, 1023)) * FULL // 1023)

    def write(self, value):
        if self.wave:
            self.wave.pwm.deinit()
            self.wave = None
            self.plain = pin(self.name, Pin.OUT)
        self.plain.value(value)

    def waved(self, frequency):
        if self.wave is None:
            self.wave = Wave(self.name, frequency)
        elif self.frequency != frequency:
            self.wave.pwm.freq(frequency)
        self.frequency = frequency
        return self.wave

    def stop(self):
        self.write(0)


make = Out
