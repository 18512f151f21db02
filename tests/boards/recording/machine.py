# The module `machine` of a board whose pins are wired to nothing: it remembers what it is told, and reads what a test
# puts in. That is all that is replaced when drivers are tested; they, and the MicroPython that runs them, are real.

log = []  # (pin, what, value), in order
levels = {}  # pin: what it reads, 0 or 1
volts = {}  # pin: what it reads as analogue, 0 to 65535
widths = {}  # pin: microseconds of the next answer, None for none at all; a long one comes where nothing stands
registers = {}  # of what is on an I2C bus: {address: {register: bytes}}; nothing else answers
watchers = {}  # pin: what is called when it changes
partners = {}  # UART: who gets what is written to it, or b"" when it is looked at, and gives what it then says
NAMES = ("LED",)
PINS = 30


class Pin:
    IN = 0
    OUT = 1
    PULL_UP = 2
    PULL_DOWN = 3
    IRQ_RISING = 1
    IRQ_FALLING = 2

    def __init__(self, name, mode=None, pull=None):
        if name not in NAMES and not (isinstance(name, int) and 0 <= name < PINS):
            raise ValueError("invalid pin")
        self.name = name
        self.init(mode, pull)

    def init(self, mode=None, pull=None):
        if mode is not None:
            log.append((self.name, "out" if mode == Pin.OUT else "in", pull))

    def value(self, level=None):
        if level is None:
            return levels.get(self.name, 0)
        levels[self.name] = level
        log.append((self.name, "value", level))

    def irq(self, handler, trigger):
        watchers[self.name] = handler


class I2C:
    def __init__(self, number, sda=None, scl=None, freq=400000):
        self.number = number

    def here(self, address):
        if address not in registers:
            raise OSError(19)
        return registers[address]

    def readfrom_mem(self, address, register, count):
        data = self.here(address).get(register, b"")
        return (data + bytes(count))[:count]

    def writeto_mem(self, address, register, data):
        self.here(address)
        log.append((address, register, bytes(data)))


class UART:
    def __init__(self, number, baudrate=9600, tx=None, rx=None, rxbuf=256):
        self.number = number
        self.waiting = b""
        log.append(("uart", baudrate, (number, tx, rx)))

    def hand(self, data):
        if self.number in partners:
            self.waiting += partners[self.number](data)

    def any(self):
        self.hand(b"")
        return len(self.waiting)

    def read(self, count):
        data, self.waiting = self.waiting[:count], self.waiting[count:]
        return data or None

    def write(self, data):
        log.append(("uart", "write", bytes(data)))
        self.hand(bytes(data))


class PWM:
    def __init__(self, pin, freq=None, duty_u16=None):
        self.name = pin.name
        if freq is not None:
            self.freq(freq)
        if duty_u16 is not None:
            self.duty_u16(duty_u16)

    def freq(self, hertz):
        log.append((self.name, "freq", hertz))

    def duty_u16(self, part):
        log.append((self.name, "duty", part))

    def deinit(self):
        log.append((self.name, "deinit", None))


class OldPWM:
    """As on an ESP8266: a duty of ten bits."""

    def __init__(self, pin):
        self.name = pin.name

    def freq(self, hertz):
        log.append((self.name, "freq", hertz))

    def duty(self, part):
        log.append((self.name, "duty10", part))


class ADC:
    def __init__(self, pin):
        self.name = pin.name

    def read_u16(self):
        return volts.get(self.name, 0)


def time_pulse_us(pin, level, timeout=1000000):
    log.append((pin.name, "wait", timeout))
    width = widths.get(pin.name, 1000000)
    return -2 if width is None else width if width <= timeout else -1
