# The loudspeaker of a micro:bit V2: what `music` plays, without a pin.

from microbit import speaker

from kitrobot_onboard.drivers.microbit.music import Music

CHIP = "nrf52833"
SETTINGS = {}
PROCEDURES = "Tone Play Stop"


def make(settings):
    speaker.on()
    # No pin: its MicroPython plays through the loudspeaker alone then.
    return Music((None,))
