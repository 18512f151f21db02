# A reflectance sensor of the RC kind (Pololu QTR): its capacitor is charged, and the less light comes back, the longer
# its pin stays high. `emitter` is the pin that lights its lamp, and is an input while nobody looks.

from time import sleep_us

from machine import Pin, time_pulse_us

from kitrobot_onboard.drivers.machine.pins import pin

CHARGE_US = 32


class Decay:
    def __init__(self, name, emitter):
        self.pin = pin(name, Pin.IN)
        self.emitter = pin(emitter, Pin.IN)

    def look(self, most):
        """Microseconds that the pin stays high, `most` for longer ones; it takes no more."""
        self.emitter.init(Pin.OUT)
        self.emitter.value(1)
        self.pin.init(Pin.OUT)
        self.pin.value(1)
        sleep_us(CHARGE_US)
        self.pin.init(Pin.IN)
        width = time_pulse_us(self.pin, 1, most)
        self.emitter.init(Pin.IN)
        if width == -2:  # it was low at once
            return 0
        return most if width < 0 else width
