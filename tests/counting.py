"""How much work something is, in calls of functions, Python's own among them: no busy machine changes it."""

from __future__ import annotations

import cProfile
import gc
from collections.abc import Callable

MOST = 2.3
"""How many times as much work twice as much may be."""


def calls(work: Callable[[], object]) -> int:
    """How many functions are called."""
    counter = cProfile.Profile(builtins=True)
    gc.disable()
    try:
        counter.runcall(work)
    finally:
        gc.enable()
    return sum(entry.callcount for entry in counter.getstats())


def growth(work: Callable[[int], Callable[[], object]], n: int) -> float:
    """How many times as many calls `work(2 * n)` takes as `work(n)`."""
    work(2)()  # what is done once only, whatever the size, is done
    return calls(work(2 * n)) / calls(work(n))
