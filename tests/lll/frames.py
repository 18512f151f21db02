"""How much of the host's recursion something may use."""

from __future__ import annotations

import inspect
import sys
from collections.abc import Iterator
from contextlib import contextmanager


@contextmanager
def at_most_frames(count: int) -> Iterator[None]:
    """Leaves so many nested calls to what runs inside; one more is a RecursionError."""
    before = sys.getrecursionlimit()
    sys.setrecursionlimit(len(inspect.stack(0)) + count)
    try:
        yield
    finally:
        sys.setrecursionlimit(before)
