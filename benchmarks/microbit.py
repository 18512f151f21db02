"""The one `tick` on the smallest board, against the same loop by hand: the real firmware of the micro:bit in QEMU.

    python -m benchmarks.microbit

Every instruction of the emulated processor takes 64 ns (`-icount shift=6`; the real one has 16 MHz), so the numbers are
the same each time and on any machine. The loop is that of `subjects.interpreting`.
"""

from __future__ import annotations

import ast
from importlib.resources import files

from benchmarks.subjects import interpreting
from kitrobot.deploy.line.line import Line
from kitrobot.deploy.line.receiver import Receiver
from kitrobot.deploy.line.repl import RawRepl
from kitrobot.deploy.minification.minifier import parsed, shortened

TICKS = 500
BY_TICK = """
from kri import tick
from utime import ticks_diff, ticks_us
code = {code!r}
cells = {cells!r}
threads = {threads!r}
pars = {pars!r}
out = {out!r}
def act(x):
    pass
begun = ticks_us()
for _ in range({ticks}):
    tick(code, cells, threads, pars, out, ())
    if out[0]:
        act(out[3])
print("took", ticks_diff(ticks_us(), begun), cells[{count}])
"""
BY_HAND = """
from utime import ticks_diff, ticks_us
def act(x):
    pass
class ByHand:
    def __init__(self):
        self.i = 0
        self.x = 0
    def step(self):
        self.i += 1
        self.x += 3
        act(self.x)
        return self.i < 1000
program = ByHand()
begun = ticks_us()
for _ in range({ticks}):
    program.step()
print("took", ticks_diff(ticks_us(), begun), program.i)
"""


def seconds(files_on_it: dict[str, bytes]) -> float:
    """The time that main.py says it took, in seconds of the board."""
    from tests.boards.qemu import running

    with running("-icount", "shift=6") as board:
        line = Line(board.address)
        try:
            receiver = Receiver(RawRepl(line))
            receiver.begin()
            for name, content in files_on_it.items():
                receiver.write(name, content)
            receiver.end()
            line.write(b"\x03\x02")
            line.read_until(b">>> ", 10)
            line.write(b"\x04")
            heard = line.read_until(b">>> ", 60)
        finally:
            line.close()
    _, found, rest = heard.partition(b"took ")
    if not found:
        raise RuntimeError(heard.decode(errors="replace"))
    took, count = (int(word) for word in rest.split()[:2])
    if count != TICKS:
        raise RuntimeError(f"{count} trips instead of {TICKS}")
    return took / 1e6


def main() -> None:
    """Prints both rates."""
    machine = interpreting.machine()
    a_trip = interpreting.instructions_a_trip(interpreting.machine())
    source = files("kitrobot_onboard").joinpath("interpreter.py").read_text(encoding="utf-8")
    given = {
        "code": bytes(machine.code),
        "cells": machine.cells,
        "threads": machine.threads,
        "pars": machine.pars,
        "out": machine.out,
        "ticks": TICKS,
        "count": machine.layout.variables["Count"],
    }
    short = shortened(parsed(source, "interpreter.py")).encode()
    program = shortened(ast.parse(BY_TICK.format(**given))).encode()
    ours = TICKS / seconds({"kri.py": short, "main.py": program})
    by_hand = TICKS / seconds({"main.py": BY_HAND.format(ticks=TICKS).encode()})
    print(f"tick: {ours:.0f} ticks/s, {ours * a_trip:.0f} instructions/s; by hand: {by_hand:.0f} trips/s")


if __name__ == "__main__":
    main()
