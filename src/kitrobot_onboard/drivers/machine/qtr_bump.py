# A bumper whose flaps reflectance sensors of the RC kind look at (see `shared.decays`), one on each side: 1 while one
# is pressed. That is, its reading is `press` percent of what it was when the robot stood free, as it began, and not yet
# below `release` percent. One to which no light comes back then is not plugged in, or not in its place.

from kitrobot_onboard.drivers.machine.shared.decays import Decay

SETTINGS = {
    "left": "shared",
    "right": "shared",
    "emitter": "shared",
    "press": "105..400 = 160",
    "release": "101..400 = 140",
}
MOST = 1000  # microseconds that are waited for a sensor
LOOKS = 10


class Flap:
    def __init__(self, name, emitter):
        self.sensor = Decay(name, emitter)
        self.rest = sum([self.sensor.look(MOST) for _ in range(LOOKS)]) // LOOKS
        if self.rest >= MOST:
            raise OSError("no light comes back: not plugged in?")
        self.pressed = False


class Bumper:
    def __init__(self, settings):
        self.press = int(settings.get("press", "160"))
        self.release = int(settings.get("release", "140"))
        self.flaps = [Flap(settings[side], settings["emitter"]) for side in ("left", "right")]

    def read(self):
        pressed = 0
        for flap in self.flaps:
            most = min(flap.rest * (self.release if flap.pressed else self.press) // 100 + 1, MOST)
            flap.pressed = flap.sensor.look(most) >= most
            pressed = pressed or flap.pressed
        return 1 if pressed else 0


make = Bumper
