"""Rates from repeated runs, and the rows that compare our rate with a peer's.

Seconds are processor time of the measuring thread: the time that the work takes on an otherwise idle machine. Several
pieces of work are measured in turns (one round of each, then the next round), so that a machine that is slower for a
while is slower for all of them. A rate is the median of its rounds, never the best.
"""

from __future__ import annotations

import gc
import os
import statistics
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class Rate:
    """Work a second: the median of all rounds, the slowest and the fastest."""

    median: float
    slowest: float
    fastest: float

    @classmethod
    def of(cls, amount: float, seconds: list[float]) -> Rate:
        """The rate at which `amount` was done, each round in its time."""
        return cls(*(amount / take(seconds) for take in (statistics.median, max, min)))


@dataclass(frozen=True)
class Row:
    """One line of the table. `peer` is empty where nothing comparable exists, `theirs` None where it did not run.

    `lower_is_better`: the numbers are what it costs, milliseconds or bytes, not rates.
    """

    what: str
    unit: str
    ours: Rate
    peer: str = ""
    theirs: Rate | None = None
    lower_is_better: bool = False

    @property
    def ratio(self) -> float | None:
        """How many times as fast as the peer we are; below 1 we are slower."""
        if self.theirs is None:
            return None
        ratio = self.ours.median / self.theirs.median
        return 1 / ratio if self.lower_is_better else ratio


def checkout_environment() -> dict[str, str]:
    """The environment of a Python process that runs this checkout, and not a KitRobot that is installed."""
    root = Path(__file__).resolve().parents[1]
    return {**os.environ, "PYTHONPATH": os.pathsep.join((str(root / "src"), str(root)))}


def in_turns(work: Mapping[str, Callable[[], object]], rounds: int) -> dict[str, list[float]]:
    """Seconds of each round of each piece of work, after one round that does not count.

    Garbage is collected before each round, as usual during it, and what a round leaves for the collector to look at
    later is looked at in its time.
    """
    seconds: dict[str, list[float]] = {name: [] for name in work}
    for number in range(rounds + 1):
        for name, do in work.items():
            gc.collect()
            begun = time.thread_time()
            made = do()
            gc.collect(0)
            taken = time.thread_time() - begun
            del made
            if number:
                seconds[name].append(taken)
    return seconds


def milliseconds(seconds: list[float]) -> Rate:
    """The times themselves, in milliseconds."""
    return Rate(*(1000 * take(seconds) for take in (statistics.median, max, min)))
