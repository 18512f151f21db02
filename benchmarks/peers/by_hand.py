# The loop `i+=1; x+=3; act(x); until i=1000` as somebody would write it by hand in MicroPython, beside the same program
# of KitRobot run by `tick`: run by MicroPython for WebAssembly (tests/boards/webassembly/run.mjs), which calls `step`.
# A trip is a call of the program's function, as it is a tick. Prints a line of JSON: seconds of each round.

import binascii
import json

from js import thread_time_us

from kitrobot_onboard.image import load
from kitrobot_onboard.interpreter import tick

with open("given.json") as file:
    given = json.load(file)
UNTIL = 1000
code, cells, threads, pars, out = load(binascii.unhexlify(given["image"]))
first = cells[:], threads[:], pars[:]
acted = [0, 0]


def act(x):
    acted[0] += 1
    acted[1] = x


class ByHand:
    def __init__(self):
        self.i = 0
        self.x = 0

    def step(self):
        self.i += 1
        self.x += 3
        act(self.x)
        return self.i < UNTIL


def by_tick(laps):
    for _ in range(laps):
        cells[:], threads[:], pars[:] = first
        while threads[0] >= 0:
            tick(code, cells, threads, pars, out, [])
            if out[0]:
                act(out[3])


def by_hand(laps):
    for _ in range(laps):
        program = ByHand()
        while program.step():
            pass


rounds = {"tick": [], "hand": []}
left = 2 * (given["rounds"] + 1)


def step():
    """A round of one of the two; the first one of each does not count."""
    global left
    name, work = ("tick", by_tick) if left % 2 == 0 else ("hand", by_hand)
    left -= 1
    acted[0] = 0
    begun = thread_time_us()
    work(given["laps"])
    taken = (thread_time_us() - begun) / 1e6
    if acted != [given["laps"] * UNTIL, 3 * UNTIL]:
        raise ValueError(acted)
    if left < 2 * given["rounds"]:
        rounds[name].append(taken)
    if left == 0:
        print(json.dumps(rounds))
    return left > 0
