"""Recordings: what an hour of ten robots weighs, and how long it takes to open it and to go anywhere in it.

Ten robots of the swarm (see benchmarks/swarm.py) look about with three range rays each, decide, drive, and run into
walls and one another for a simulated hour, which no example does: all of those end. Recorded is every tick. Nothing of
a peer's is comparable: no other records every robot's values and threads at each tick. Milliseconds are on the clock,
as a person who drags the timeline meets them.
"""

from __future__ import annotations

import random
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

from benchmarks.measurement import Rate, Row, milliseconds
from benchmarks.swarm import swarm
from kitrobot.sim.recorder import simulate
from kitrobot.trace.ros.mcap_export import mcap_bytes
from kitrobot.workspace.traces import open_trace

TITLE = "tracing"
ROBOTS = 10


@dataclass(frozen=True)
class Size:
    """`seconds`: simulated; `seeks`: moments gone to."""

    seconds: float
    seeks: int


FULL = Size(3600, 200)
TINY = Size(5, 3)


def run(size: Size, *, peers: bool) -> list[Row]:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "hour.krtrace"
        simulation = swarm(ROBOTS)
        begun = time.thread_time()
        simulate(simulation, path, lambda run: run.seconds >= size.seconds)
        recording = time.thread_time() - begun
        weight = path.stat().st_size / 1e6 * 3600 / simulation.seconds
        opening = []
        for _ in range(5):
            begun = time.perf_counter()
            trace = open_trace(path)
            opening.append(time.perf_counter() - begun)
            trace.reader.close()
        trace = open_trace(path)
        chance, seeking = random.Random(1), []
        with trace.reader as reader:
            for _ in range(size.seeks):
                tick = chance.randrange(reader.last_tick + 1)
                begun = time.perf_counter()
                assert reader.seek(tick).tick == tick
                seeking.append(time.perf_counter() - begun)
            begun = time.thread_time()
            mcap_bytes(reader)
            exporting = (time.thread_time() - begun) * 3600 / simulation.seconds
    hour = f"an hour of {ROBOTS} robots"
    return [
        Row(f"{hour}, on disk", "MB", Rate(weight, weight, weight), lower_is_better=True),
        Row(f"{hour}, recorded", "× real time", Rate.of(simulation.seconds, [recording])),
        Row(f"{hour}, opened", "ms", milliseconds(opening), lower_is_better=True),
        Row(f"{hour}, as MCAP", "s", Rate(exporting, exporting, exporting), lower_is_better=True),
        Row(f"{hour}, to any moment", "ms", milliseconds(seeking), lower_is_better=True),
    ]
