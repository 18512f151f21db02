"""What Numba compiles before a check is what the check calls; nothing is compiled here."""

from __future__ import annotations

import gc
import weakref

import pytest

from kitrobot.sim.jit.table_pointer import TablePointer
from kitrobot.verifier.exploration import state_filter, step_batches
from kitrobot.verifier.exploration.approximate_search import ApproximateSpace
from kitrobot.verifier.exploration.engines import FUNCTIONS, PLAIN, ArrayGraph, ArrayTables, array_engine
from kitrobot.verifier.exploration.exploration import fresh_graph
from kitrobot.verifier.exploration.numba_engine import cache_folder, samples
from kitrobot.verifier.model.abstraction import abstract_run
from kitrobot.verifier.model.model import Model
from kitrobot.verifier.tables.dynamic_arrays import grow_table
from tests.sim.building import transport


def test_functions_are_compiled_for_the_tables_that_they_are_given() -> None:
    """Numba would compile a function once more for a pointer to other tables, in the midst of a check."""
    pytest.importorskip("numba")
    run = transport(stock=1, carriers=1)
    taken = array_engine(FUNCTIONS).take(Model(run, abstract_run(run)).t, fresh_graph(), 100)
    given = {one.layout for arguments in samples().values() for one in arguments if isinstance(one, TablePointer)}
    assert all(isinstance(tables, ArrayTables | ArrayGraph) for tables in taken)
    assert {tables.pointer.layout for tables in taken if isinstance(tables, ArrayTables | ArrayGraph)} < given
    space = ApproximateSpace(Model(run, abstract_run(run)), fresh_graph(), PLAIN)
    space.use(array_engine(FUNCTIONS))
    space.may_join(2)
    assert space.batches is not None
    assert {TablePointer(space.batches.batch).layout, TablePointer(space.kept).layout} < given
    space.batches.close()
    assert len(given) == 5  # and what a search keeps


def test_arrays_that_were_replaced_by_longer_ones_are_gone_at_once() -> None:
    """The collector may come by long after: a check has few objects, and large ones."""
    pytest.importorskip("numpy")
    run = transport(stock=1, carriers=1)
    tables, graph = array_engine(FUNCTIONS).take(Model(run, abstract_run(run)).t, fresh_graph(), 100)
    assert isinstance(tables, ArrayTables)
    assert isinstance(graph, ArrayGraph)
    old = [weakref.ref(tables.outcomes), weakref.ref(graph.slots)]
    gc.disable()
    try:
        assert tables.pointer.address != graph.pointer.address
        longer_tables = tables._replace(outcomes=grow_table(tables.outcomes, 2 * len(tables.outcomes)))
        longer_graph = graph._replace(slots=grow_table(graph.slots, 2 * len(graph.slots)))
        del tables, graph
        assert all(one() is None for one in old)
    finally:
        gc.enable()
    assert isinstance(longer_tables, ArrayTables)
    assert isinstance(longer_graph, ArrayGraph)


def test_what_is_kept_is_only_for_these_very_numbers(monkeypatch: pytest.MonkeyPatch) -> None:
    """Numba compiles in what a function takes from another module."""
    folder = cache_folder()
    assert folder == cache_folder()
    monkeypatch.setattr(state_filter, "WINDOW", step_batches.WINDOW + 1)
    assert cache_folder() != folder
