# The microphone of a micro:bit V2: how loud it is, from 0 to 255.

from microbit import microphone

CHIP = "nrf52833"
SETTINGS = {}


def make(settings):
    return microphone.sound_level
