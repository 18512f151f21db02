"""What compiled code reads through a pointer to tables is what the arrays hold, and what it writes is written there."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple

import pytest

from kitrobot.sim.jit.table_pointer import TablePointer


@dataclass(frozen=True, slots=True)
class Inner:
    rows: Any
    numbers: Any


@dataclass(frozen=True, slots=True)
class Outer:
    first: Any
    inner: Inner
    last: Any


def work(tables: Any) -> int:
    total = len(tables.inner.rows) * 1000 + len(tables.inner.rows[1]) * 100 + len(tables.last)
    tables.inner.rows[1][2] = tables.first[1] + tables.inner.numbers[0]
    tables.last[1] = 0.5
    return total


def test_compiled_code_reads_and_writes_the_arrays_of_every_group() -> None:
    np = pytest.importorskip("numpy")
    numba = pytest.importorskip("numba")
    from kitrobot.sim.jit import numba_tables

    tables = Outer(
        np.array([3, 4]), Inner(np.arange(8, dtype=np.int32).reshape(2, 4), np.array([7], np.uint8)), np.zeros(2)
    )
    pointer = TablePointer(tables)
    assert numba_tables.pointer_type(pointer.layout).words == 2 + 3 + 2 + 2
    assert numba.njit(_nrt=False)(work)(pointer) == 2402
    assert tables.inner.rows.tolist() == [[0, 1, 2, 3], [4, 5, 11, 7]]
    assert tables.last.tolist() == [0.0, 0.5]


def test_an_array_that_is_not_contiguous_is_refused() -> None:
    np = pytest.importorskip("numpy")
    with pytest.raises(ValueError, match="the table rows is not contiguous"):
        TablePointer(Inner(np.zeros((4, 4))[:, ::2], np.zeros(1)))


class Named(NamedTuple):
    numbers: Any


def test_a_named_tuple_is_reached_as_a_dataclass_is() -> None:
    np = pytest.importorskip("numpy")
    numba = pytest.importorskip("numba")
    from kitrobot.sim.jit import numba_tables  # noqa: F401 (it tells Numba what a pointer to tables is)

    def write(tables: Any) -> int:
        tables.numbers[0] = 5
        return len(tables.numbers)

    tables = Named(np.zeros(3, np.int32))
    assert numba.njit(_nrt=False)(write)(TablePointer(tables)) == 3
    assert tables.numbers.tolist() == [5, 0, 0]
