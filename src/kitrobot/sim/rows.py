"""The two things that lists and Numba's arrays do not say alike, or not as fast as they could.

`compiling` tells Numba in loops what they mean for arrays.
"""

from __future__ import annotations


def same(one: list[int], other: list[int]) -> bool:
    """Whether two rows hold the same numbers."""
    return one == other


def copy_row(to: list[int], row: list[int]) -> None:
    """Makes a row hold what another one holds; a list also becomes as long."""
    to[:] = row
