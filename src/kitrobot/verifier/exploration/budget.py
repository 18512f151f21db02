"""The limits of a check (states, seconds, bytes), and the reasons why one ends early."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum

LARGE = 100_000
"""States from which on more than one core pays."""


class CutReason(Enum):
    """Why the exploration, or a later search of the state space, ended early."""

    STATES = "states"
    """The limit of states was reached."""
    MEMORY = "memory"
    """The limit of memory was reached."""
    TIME = "time"
    STOPPED = "stopped"
    """The user stopped it."""
    SIZE = "size"
    """The model is too large: a step has too many outcomes, or a state does not fit into a key."""


@dataclass(frozen=True)
class Budget:
    """The limits of an exploration.

    Attributes:
        states: the most states; None for as many as time and memory allow.
        seconds: the most seconds of wall-clock time; None for no limit.
        memory: about the most bytes of the whole process (see `memory`); None for no limit.
        stop: polled now and then; True stops the exploration.
        progress: called now and then with the number of states and the depth.
        clock: the clock, in seconds.
        cores: at most so many cores explore beside each other, once they pay.
        alone: up to so many states one core explores alone.
    """

    states: int | None = 1_000_000
    seconds: float | None = None
    memory: int | None = None
    stop: Callable[[], bool] = lambda: False
    progress: Callable[[int, int], None] = lambda states, depth: None
    clock: Callable[[], float] = time.monotonic
    cores: int = 1
    alone: int = LARGE

    def interruption(self, began: float) -> Callable[[], CutReason | None]:
        """Makes a function that returns whether a task that started at `began` has to end: stopped, or out of time."""
        ends = None if self.seconds is None else began + self.seconds

        def interruption() -> CutReason | None:
            if self.stop():
                return CutReason.STOPPED
            return CutReason.TIME if ends is not None and self.clock() >= ends else None

        return interruption
