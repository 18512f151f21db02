"""The limits of a check (states, seconds, bytes), and the reasons why one ends early."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum


class CutReason(Enum):
    """Why exploring, or looking through what was explored, ended before all was seen."""

    STATES = "states"
    """There were as many states as were allowed."""
    MEMORY = "memory"
    """They took as much memory as was allowed."""
    TIME = "time"
    STOPPED = "stopped"
    """Somebody broke it off."""
    SIZE = "size"
    """The model is too large to be kept: a step goes in too many ways, or a state has no room in a key."""


@dataclass(frozen=True)
class Budget:
    """How far to explore.

    Attributes:
        states: at most so many; None for as many as there is time and memory for.
        seconds: at most so long, on the clock on the wall; None for no limit.
        memory: at most so many bytes of the whole process, about (see `memory`); None for no limit.
        stop: asked now and then whether to break off.
        progress: told now and then how many states there are and how deep.
        clock: what tells the time, in seconds.
    """

    states: int | None = 1_000_000
    seconds: float | None = None
    memory: int | None = None
    stop: Callable[[], bool] = lambda: False
    progress: Callable[[int, int], None] = lambda states, depth: None
    clock: Callable[[], float] = time.monotonic

    def interruption(self, began: float) -> Callable[[], CutReason | None]:
        """Asked whether it is stopped, or time is up for what began then."""
        ends = None if self.seconds is None else began + self.seconds

        def interruption() -> CutReason | None:
            if self.stop():
                return CutReason.STOPPED
            return CutReason.TIME if ends is not None and self.clock() >= ends else None

        return interruption
