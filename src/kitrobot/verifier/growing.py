"""Tables that grow: lists, arrays of Python's, arrays of NumPy's."""

from __future__ import annotations

from array import array
from typing import Any


def longer(table: Any, size: int, free: int = 0) -> Any:
    """A table of this size, which begins with what it held; a list or an array as before."""
    if isinstance(table, list):
        return table + [free] * (size - len(table))
    if isinstance(table, array):
        return table + array(table.typecode, bytes(table.itemsize * (size - len(table))))
    import numpy as np

    made = np.full(size, free, table.dtype) if free else np.zeros(size, table.dtype)
    made[: len(table)] = table
    return made
