"""Whether two rows of numbers are the same: the one thing that lists and Numba's arrays do not say alike."""

from __future__ import annotations


def same(one: list[int], other: list[int]) -> bool:
    """Whether two rows hold the same numbers. `compiling` tells Numba what this means for arrays."""
    return one == other
