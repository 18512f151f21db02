"""The two things that lists and Numba's arrays do not say alike, or not as fast as they could.

`sim.jit.compiler` tells Numba in loops what they mean for arrays.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeVar

Number = TypeVar("Number", int, float)


def same(one: Sequence[float], other: Sequence[float]) -> bool:
    """Whether two rows hold the same numbers."""
    return one == other


def copy_row(to: list[Number], row: list[Number]) -> None:
    """Makes a row hold what another one holds; a list also becomes as long."""
    to[:] = row
