"""What Numba compiles before a check is what the check calls; nothing is compiled here."""

from __future__ import annotations

import pytest

from kitrobot.sim.table_pointer import TablePointer
from kitrobot.verifier import Model, take_apart
from kitrobot.verifier.compiling import samples
from kitrobot.verifier.engines import FUNCTIONS, arrays
from kitrobot.verifier.exploring import fresh_graph
from tests.sim.building import transport


def test_functions_are_compiled_for_the_tables_that_they_are_given() -> None:
    """Numba would compile a function once more for a pointer to other tables, in the midst of a check."""
    pytest.importorskip("numba")
    run = transport(stock=1, carriers=1)
    taken = arrays(FUNCTIONS).take(Model(run, take_apart(run)).t, fresh_graph(), 100)
    given = {one.layout for arguments in samples().values() for one in arguments if isinstance(one, TablePointer)}
    assert {TablePointer(tables).layout for tables in taken} < given
    assert len(given) == 3  # and what a search keeps
