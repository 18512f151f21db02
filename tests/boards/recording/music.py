# The module `music` of a board that nobody hears: what it is told goes into the log of `machine`, with the number of
# the pin, 0 where it is told none, None where it is told that there is no pin.

from machine import log
from microbit import pin0

TUNES = "POWER_UP POWER_DOWN JUMP_UP JUMP_DOWN BA_DING WAWAWAWAA DADADADUM ENTERTAINER ODE BIRTHDAY RINGTONE PUNCHLINE"
for name in TUNES.split(" "):
    globals()[name] = name


def pitch(frequency, duration=-1, pin=pin0, wait=True):
    say("pitch", (frequency, duration), pin, wait)


def play(tune, pin=pin0, wait=True):
    say("play", tune, pin, wait)


def stop(pin=pin0):
    say("stop", None, pin)


def say(what, value, pin, wait=False):
    if wait:
        raise ValueError("a tick cannot wait")
    log.append(("music", what, (value, None if pin is None else pin.name)))
