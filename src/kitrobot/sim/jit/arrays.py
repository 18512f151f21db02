"""The state of a run as NumPy arrays, for Numba; ragged rows are filled up with zeros."""

from __future__ import annotations

from dataclasses import dataclass, fields, is_dataclass
from typing import Any, get_type_hints

from kitrobot.sim.jit.table_pointer import TablePointer
from kitrobot.sim.tables.state import CHANGING, FloatRows, Floats, Ints, State

_NARROW = frozenset((*CHANGING, "out", "seen")) | {f"{was}_{name}" for was in ("was", "kept") for name in CHANGING}
"""Tables of machines: 32 bits are enough for them, as on a board."""


@dataclass(frozen=True, slots=True)
class ArrayState(State):
    """A state whose tables are arrays, and the pointer to them that compiled code takes."""

    pointer: TablePointer


def as_arrays(state: State) -> ArrayState:
    """The same state as arrays; needs NumPy."""
    widths = {name: max((len(row) for row in getattr(state.machines, name)), default=0) for name in CHANGING}
    made: State = _arrays(state, {f"{was}_{name}": widths[name] for was in ("was", "kept") for name in CHANGING})
    tables = {field.name: getattr(made, field.name) for field in fields(State)}
    return ArrayState(**tables, pointer=TablePointer(made))


def _arrays(tables: Any, widths: dict[str, int]) -> Any:
    """A group of tables as arrays; `widths` are those of tables whose rows grow."""
    import numpy as np

    made: list[Any] = []
    for name, kind in get_type_hints(type(tables)).items():
        table = getattr(tables, name)
        if is_dataclass(kind):
            made.append(_arrays(table, widths))
            continue
        number: Any = np.float64 if kind in (Floats, FloatRows) else np.int32 if name in _NARROW else np.int64
        if name == "code":
            number = np.uint8
        if kind in (Floats, Ints):
            filled = np.zeros(widths.get(name, len(table)), number)
            filled[: len(table)] = table
        else:
            width = widths.get(name, max((len(row) for row in table), default=0))
            filled = np.zeros((len(table), width), number)
            for at, row in enumerate(table):
                filled[at, : len(row)] = row
        made.append(filled)
    return type(tables)(*made)
