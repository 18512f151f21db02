"""The state of a run as NumPy arrays, for Numba; ragged rows are filled up with zeros.

All of them are views of one block of memory, so a copy of that is a copy of the state.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, fields, is_dataclass
from typing import Any, get_type_hints

from kitrobot.sim.jit.table_pointer import TablePointer
from kitrobot.sim.tables.state import CHANGING, FloatRows, Floats, Ints, State

_NARROW = frozenset((*CHANGING, "out", "seen")) | {f"{was}_{name}" for was in ("was", "kept") for name in CHANGING}
"""Tables of machines: 32 bits are enough for them, as on a board."""

_ALIGNED = 64
"""Each array begins at a multiple of so many bytes from the beginning of the block."""


@dataclass(frozen=True, slots=True)
class ArrayState(State):
    """A state whose tables are arrays, the bytes of all of them, and the pointer to them that compiled code takes."""

    memory: Any
    pointer: TablePointer


def as_arrays(state: State) -> ArrayState:
    """The same state as arrays; needs NumPy."""
    widths = {name: max((len(row) for row in getattr(state.machines, name)), default=0) for name in CHANGING}
    memory = _Memory({f"{was}_{name}": widths[name] for was in ("was", "kept") for name in CHANGING}, state)
    made: State = memory.arrays(state)
    tables = {field.name: getattr(made, field.name) for field in fields(State)}
    return ArrayState(**tables, memory=memory.block, pointer=TablePointer(made))


class _Memory:
    """A block of memory for the tables of a state, given out one after another; `widths` are those of tables whose
    rows grow.
    """

    def __init__(self, widths: dict[str, int], state: State) -> None:
        import numpy as np

        self._widths = widths
        self._used = 0
        self.block: Any = np.zeros(self._size(state), np.uint8)

    def arrays(self, tables: Any) -> Any:
        """A group of tables as arrays."""
        made: list[Any] = []
        for name, kind in get_type_hints(type(tables)).items():
            table = getattr(tables, name)
            if is_dataclass(kind):
                made.append(self.arrays(table))
                continue
            shape, number = self._form(name, kind, table)
            length = math.prod(shape) * number().itemsize
            filled = self.block[self._used : self._used + length].view(number).reshape(shape)
            self._used += _whole(length)
            if kind in (Floats, Ints):
                filled[: len(table)] = table
            else:
                for at, row in enumerate(table):
                    filled[at, : len(row)] = row
            made.append(filled)
        return type(tables)(*made)

    def _form(self, name: str, kind: Any, table: Any) -> tuple[tuple[int, ...], Any]:
        """The shape of a table as an array, and what its numbers are."""
        import numpy as np

        number: Any = np.float64 if kind in (Floats, FloatRows) else np.int32 if name in _NARROW else np.int64
        if name == "code":
            number = np.uint8
        if kind in (Floats, Ints):
            return (self._widths.get(name, len(table)),), number
        return (len(table), self._widths.get(name, max((len(row) for row in table), default=0))), number

    def _size(self, tables: Any) -> int:
        """How much of it a group of tables takes."""
        size = 0
        for name, kind in get_type_hints(type(tables)).items():
            table = getattr(tables, name)
            if is_dataclass(kind):
                size += self._size(table)
            else:
                shape, number = self._form(name, kind, table)
                size += _whole(math.prod(shape) * number().itemsize)
        return size


def _whole(length: int) -> int:
    return -(-length // _ALIGNED) * _ALIGNED
