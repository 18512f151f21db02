# The module `microbit` of a board that nothing is wired to: what it is told goes into the log of `machine`, and its
# pins read what a test puts there.

import time

from machine import levels, log, registers, volts


class Pin:
    PULL_UP = 1

    def __init__(self, name):
        self.name = name

    def write_digital(self, level):
        levels[self.name] = level
        log.append((self.name, "value", level))

    def read_digital(self):
        return levels.get(self.name, 0)

    def read_analog(self):
        return volts.get(self.name, 0)

    def write_analog(self, value):
        log.append((self.name, "analog", value))

    def set_analog_period(self, ms):
        log.append((self.name, "period", ms))

    def set_pull(self, pull):
        log.append((self.name, "pull", pull))


for number in range(21):
    globals()["pin" + str(number)] = Pin(number)


class Bus:
    """Takes what is written to any address; what is there to be read is in `registers`."""

    def write(self, address, data, repeat=False):
        log.append((address, "i2c", bytes(data)))
        self.register = data[0]

    def read(self, address, count):
        if address not in registers:
            raise OSError(19)
        return (registers[address].get(self.register, b"") + bytes(count))[:count]


class Display:
    def show(self, picture, wait=True):
        log.append(("display", "show", picture if isinstance(picture, str) else picture.text))

    def scroll(self, text, delay=150, wait=True):
        log.append(("display", "scroll", text))

    def set_pixel(self, x, y, level):
        log.append(("display", (x, y), level))


class Image:
    def __init__(self, text=""):
        self.text = text


class Button:
    def __init__(self, name):
        self.name = name

    def is_pressed(self):
        return levels.get(self.name, 0)


class Accelerometer:
    def was_gesture(self, name):
        return levels.get(name, 0)


class Logo:
    def is_touched(self):
        return bool(levels.get("logo", 0))


class Speaker:
    def on(self):
        log.append(("speaker", "on", None))

    def off(self):
        log.append(("speaker", "off", None))


class Microphone:
    def sound_level(self):
        return volts.get("microphone", 0)


i2c = Bus()
display = Display()
button_a = Button("a")
button_b = Button("b")
accelerometer = Accelerometer()
pin_logo = Logo()
speaker = Speaker()
microphone = Microphone()


def running_time():
    return time.ticks_ms()
