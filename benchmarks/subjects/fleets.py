"""What a team of processes takes: memory and bytes of each agent, times from a hang to a substitute's command, and from
the emergency stop until each stands still.

Each run is that of `kitrobot team` with its usual lease of 500 ms (5 s for more than ten agents), at real time, in a
process of its own (`benchmarks.fleets`). There is no peer. The bytes are those of a loopback that has nobody else on
it, TCP and the frames of bodies included.
"""

from __future__ import annotations

import json
import statistics
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from benchmarks.measurement import Rate, Row, checkout_environment

TITLE = "fleets"
MOST_S = 300
"""How long a run may take, its start included."""


@dataclass(frozen=True)
class Size:
    members: tuple[int, ...]
    seconds: float
    hangs: int
    stops: int


FULL = Size(members=(3, 10, 50), seconds=10, hangs=5, stops=10)
TINY = Size(members=(3,), seconds=0.2, hangs=0, stops=0)


def run(size: Size, *, peers: bool) -> list[Row]:
    rows: list[Row] = []
    for members in size.members:
        found = measured("cost", members, size.seconds)
        if "bytes_s" in found:
            rows.append(Row(f"{members} agents, each sends", "bytes/s", _one(found["bytes_s"]), lower_is_better=True))
        for name, what in (("pss_mb", "its share of memory"), ("rss_mb", "memory")):
            if name in found:
                rows.append(Row(f"{members} agents, each has {what}", "MB", _rate(found[name]), lower_is_better=True))
        if "ticks_s" in found:
            rows.append(Row(f"{members} agents, the world's steps of 50", "steps/s", _one(found["ticks_s"])))
    hangs = [measured("hang", 4, 0) for _ in range(size.hangs)]
    for name, what in (("taken_over_ms", "a role is taken over"), ("commands_ms", "the substitute's first command")):
        times = [found[name] for found in hangs if name in found]
        if times:
            rows.append(Row(f"from a hang until {what}", "ms", _rate(times), lower_is_better=True))
    for what, members in (("stop", 4), ("stop", 10), ("stop-boards", 4)):
        stops = [measured(what, members, 2) for _ in range(size.stops)]
        for name, who in (("stopped_ms", "a simulated one"), ("boards_ms", "a board on its line")):
            times = [time for found in stops for time in found[name]]
            if times:
                silent = sum(found["silent"] for found in stops)
                of = f"{who} of {members} agents" + (f" ({silent} did not say so)" if silent else "")
                rows.append(Row(f"from STOP until {of} stands still", "ms", _rate(times), lower_is_better=True))
    return rows


def measured(what: str, members: int, seconds: float) -> dict[str, Any]:
    """The figures of one run."""
    root = Path(__file__).parents[2]
    done = subprocess.run(
        [sys.executable, "-m", "benchmarks.fleets", what, str(members), str(seconds)],
        stdout=subprocess.PIPE,
        text=True,
        cwd=root,
        env=checkout_environment(),
        timeout=MOST_S,
        check=True,
    )
    found: dict[str, Any] = json.loads(done.stdout)
    return found


def _one(number: float) -> Rate:
    return Rate(number, number, number)


def _rate(numbers: list[float]) -> Rate:
    """The median, the largest and the smallest."""
    return Rate(statistics.median(numbers), max(numbers), min(numbers))
