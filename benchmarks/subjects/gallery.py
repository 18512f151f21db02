"""The largest program of the gallery that each kit runs, on its board in an emulator: its ticks, its memory.

There is no peer. The board is a current MicroPython as WebAssembly, whose pace is this machine's and not a board's:
`benchmarks.gallery` says how. The micro:bit of 2016 is measured by `python -m benchmarks.microbit_ticks`.
"""

from __future__ import annotations

import statistics
import sys
from dataclasses import dataclass

from benchmarks.gallery import KITS, figures_of
from benchmarks.measurement import Rate, Row
from kitrobot.workspace.kit_files import kit_named

TITLE = "gallery"


@dataclass(frozen=True)
class Size:
    """Which kits, and for how many ticks each."""

    kits: tuple[str, ...]
    ticks: int


FULL = Size(KITS, 300)
TINY = Size(("pico",), 10)


def run(size: Size, *, peers: bool) -> list[Row]:
    rows = []
    for name in size.kits:
        kit = kit_named(name)
        found = figures_of(kit, size.ticks)
        for words in found.left_out:
            print(f"{name}: left out {words}", file=sys.stderr)
        what = f"{name}, {found.program.name}"
        tick_ms = found.program.robot.tick_ms
        memory = Rate(found.memory, found.memory, found.memory)
        rows += [
            Row(f"{what}: between ticks of {tick_ms} ms", "ms", _ms(found.intervals_us), lower_is_better=True),
            Row(f"{what}: a tick as fast as it goes, 1 ms at least", "ms", _ms(found.busy_us), lower_is_better=True),
            Row(f"{what}: memory taken", "bytes", memory),
        ]
    return rows


def _ms(times_us: list[int]) -> Rate:
    """The median, the longest and the shortest; where the clock counts whole milliseconds, the shortest that is one."""
    times = [time for time in times_us if time] or [1000]
    return Rate(*(take(times) / 1000 for take in (statistics.median, max, min)))
