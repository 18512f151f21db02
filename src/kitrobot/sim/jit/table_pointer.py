"""A pointer to the arrays of a group of tables: what compiled code is given, instead of every array by value.

Numba passes a named tuple of arrays by value: of each array seven words and more, at each call of each function. The
128 arrays of a state made that nearly all of what LLVM had to compile. A pointer is one word; `numba_tables` tells
Numba what it leads to.
"""

from __future__ import annotations

from dataclasses import fields, is_dataclass
from typing import Any

Layout = tuple[str, tuple[tuple[str, Any], ...]]
"""The name of a group and its tables in their order, each with its name and the layout of its group, or its data type
and how many dimensions it has."""


class TablePointer:
    """Leads to the arrays of a group, and of the groups in it, for as long as it lives.

    Attributes:
        layout: the names and kinds of the arrays.
        address: of the first of the words: the address and the shape of each array, one after another.
    """

    __slots__ = ("_tables", "_words", "address", "layout")

    def __init__(self, tables: Any) -> None:
        """Points to the arrays of a dataclass or of a named tuple; they must not be replaced by others afterwards.

        Raises:
            ValueError: an array is not contiguous in the order of C; compiled code would read other numbers.
        """
        import numpy as np

        words: list[int] = []
        self.layout = _layout(tables, words)
        self._tables = tables
        self._words = np.array(words, np.int64)
        self.address = int(self._words.ctypes.data)


def _layout(tables: Any, words: list[int]) -> Layout:
    """The layout of a group; its words are written behind the others."""
    kinds: list[tuple[str, Any]] = []
    names = [field.name for field in fields(tables)] if is_dataclass(tables) else tables._fields
    for name in names:
        table = getattr(tables, name)
        if is_dataclass(table):
            kinds.append((name, _layout(table, words)))
            continue
        if not table.flags.c_contiguous:
            raise ValueError(f"the table {name} is not contiguous")
        kinds.append((name, (table.dtype.str, table.ndim)))
        words += (table.__array_interface__["data"][0], *table.shape)
    return type(tables).__name__, tuple(kinds)
