"""Where two texts, or lists, differ."""

from __future__ import annotations

from collections.abc import Callable, Sequence


def common_affixes(one: Sequence[object], other: Sequence[object]) -> tuple[int, int]:
    """How much two texts, or two lists, have in common at their beginnings, and behind that at their ends."""
    shorter = min(len(one), len(other))
    start = _most(shorter, lambda count: one[:count] == other[:count])
    return start, _most(shorter - start, lambda count: one[len(one) - count :] == other[len(other) - count :])


def _most(limit: int, holds: Callable[[int], bool]) -> int:
    """The largest number up to a limit for which something holds that holds for all smaller ones."""
    low, high = 0, limit
    while low < high:
        middle = (low + high + 1) // 2
        low, high = (middle, high) if holds(middle) else (low, middle - 1)
    return low
