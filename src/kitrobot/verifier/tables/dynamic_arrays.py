"""Tables that grow: lists, bytes, arrays of Python's `array` module, and NumPy arrays."""

from __future__ import annotations

from array import array
from typing import Any

from kitrobot.verifier.tables import columns as v
from kitrobot.verifier.tables.tables import Tables, find
from kitrobot.verifier.tables.traffic import fill_conf_slots

_AT_ONCE = 100_000
"""The numbers that a Python `array` grows by at once."""


def grow_table(table: Any, size: int, free: int = 0) -> Any:
    """Enlarges a table to this size, as the same type; new places hold `free`.

    A Python `array` is enlarged in place: a large one needs no second copy.
    """
    if isinstance(table, list):
        return table + [free] * (size - len(table))
    if isinstance(table, array):
        while len(table) < size:
            table.frombytes(bytes(table.itemsize * min(_AT_ONCE, size - len(table))))
        return table
    if isinstance(table, bytearray):
        return table + bytes(size - len(table))
    import numpy as np

    made = np.full(size, free, table.dtype) if free else np.zeros(size, table.dtype)
    made[: len(table)] = table
    return made


def insert(t: Tables, keys: str, values: str, count: int, key: int, value: int) -> Tables:
    """Inserts a value into a table with open addressing, at most half of which is used."""
    if 2 * count > len(getattr(t, keys)):
        old_keys, old = getattr(t, keys), getattr(t, values)
        size = 2 * len(old_keys)
        new_keys, new = grow_table(old_keys[:0], size, -1), grow_table(old[:0], size, 0)
        for at, one in enumerate(old_keys):
            if one >= 0:
                to = find(new_keys, int(one))
                new_keys[to], new[to] = one, old[at]
        t = t._replace(**{keys: new_keys, values: new})
    at = find(getattr(t, keys), key)
    getattr(t, keys)[at], getattr(t, values)[at] = key, value
    return t


def widen_insides(t: Tables, agents: int) -> Tables:
    """Doubles the rows of `insides` of each agent."""
    fixed, old = t.fixed, t.insides
    stride, size = int(fixed[v.INSIDE_STRIDE]), int(fixed[v.INSIDE_STRIDE]) * int(fixed[v.INSIDE_WIDTH])
    new = grow_table(old[:0], 2 * len(old), -1)
    for i in range(agents):
        new[2 * i * size : (2 * i + 1) * size] = old[i * size : (i + 1) * size]
    fixed[v.INSIDE_STRIDE] = 2 * stride
    return t._replace(insides=new)


def rebuild_conf_slots(t: Tables) -> None:
    """Rebuilds the slots of confs."""
    if isinstance(t.confs, list):
        fill_conf_slots(t)
        return
    # Lists: reading one number of an array from here takes several times as long.
    names = ("regs", "fixed", "confs", "conf_slots")
    lists = t._replace(**{name: getattr(t, name).tolist() for name in names})
    fill_conf_slots(lists)
    t.conf_slots[:] = lists.conf_slots
