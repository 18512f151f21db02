"""The state of a run as NumPy arrays, for Numba; ragged rows are filled up with zeros.

Numba takes groups of arrays as named tuples, and CPython reads the attributes of objects with slots in a third of the
time. So this module has a named tuple for each group of `state`, with the same name and the same fields.
"""

from __future__ import annotations

import sys
from collections import namedtuple
from dataclasses import fields, is_dataclass
from typing import Any, cast, get_type_hints

from kitrobot.sim import state as groups
from kitrobot.sim.state import CHANGING, FloatRows, Floats, Ints, State

_NARROW = frozenset((*CHANGING, "out", "seen")) | {f"{was}_{name}" for was in ("was", "kept") for name in CHANGING}
"""Tables of machines: 32 bits are enough for them, as on a board."""

_TUPLES: dict[type, Any] = {
    group: namedtuple(group.__name__, [field.name for field in fields(group)], module=__name__)
    for group in vars(groups).values()
    if isinstance(group, type) and is_dataclass(group)
}
# Numba finds them by these names when it loads what is kept.
vars(sys.modules[__name__]).update({f"{tables.__name__}": tables for tables in _TUPLES.values()})


def as_arrays(state: State) -> State:
    """The same state as arrays; needs NumPy."""
    widths = {name: max((len(row) for row in getattr(state.machines, name)), default=0) for name in CHANGING}
    made = _arrays(state, {f"{was}_{name}": widths[name] for was in ("was", "kept") for name in CHANGING})
    return cast(State, made)


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
    return _TUPLES[type(tables)](*made)
