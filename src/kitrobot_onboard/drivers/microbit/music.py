# A buzzer at a pin: a tone, or a melody by its number; both end by themselves.

import microbit
import music

SETTINGS = {"pin": "pin = 0"}
PROCEDURES = "Tone Play Stop"

# In the order of docs/xml.md, each with how many eighths of a second it takes.
MELODIES = (
    "POWER_UP9,POWER_DOWN9,JUMP_UP5,JUMP_DOWN5,BA_DING4,WAWAWAWAA21,DADADADUM32,ENTERTAINER27,ODE128,BIRTHDAY96,"
    "RINGTONE22,PUNCHLINE21,"
)


class Music:
    def __init__(self, pins):
        self.pins = pins
        self.until = 0

    def do(self, procedure, arguments):
        self.stop()
        length = 0
        if procedure == "Tone":
            length = arguments[1] if len(arguments) > 1 else -1
            if arguments[0] > 0 and length:
                music.pitch(arguments[0], length, *self.pins, wait=False)
        elif procedure == "Play":
            at = 0
            for _ in range(min(arguments[0], 11)):
                at = MELODIES.find(",", at) + 1
            word = MELODIES[at : MELODIES.find(",", at)]
            name = word.rstrip("0123456789")
            length = 125 * int(word[len(name) :])
            music.play(getattr(music, name), *self.pins, wait=False)
        self.until = microbit.running_time() + length

    def done(self):
        return microbit.running_time() >= self.until

    def stop(self):
        music.stop(*self.pins)


def make(settings):
    # Pin 0 goes without saying: the firmware of 2016, told of it, does not come back from a tone.
    pin = settings.get("pin", "0")
    return Music(() if pin == "0" else (getattr(microbit, "pin" + pin),))
