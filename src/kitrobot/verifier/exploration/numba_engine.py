"""The engine that Numba compiles from the functions of `engines` (see `sim.jit.cache`)."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

from kitrobot.sim.jit.cache import CALLED, Compilation, folder_of, functions_called, njit
from kitrobot.sim.jit.table_pointer import TablePointer
from kitrobot.verifier.exploration import engines, fairness
from kitrobot.verifier.exploration.fairness import MASKS, ComponentSearch
from kitrobot.verifier.tables import tables
from kitrobot.verifier.tables.tables import StateFilter, StepBatch

_INLINED = frozenset(
    {
        "look_up_change",
        "decode",
        "emit_step",
        "find",
        "block_of",
        "insert_hash",
        "key_hash",
        "layout_free_hash",
        "note_state",
        "sense_key",
        "touch",
        "with_field",
    }
)
"""Short functions that run many times for each state. Inlining longer ones too makes exploration no faster, and
compilation half as long again."""


def compiled_functions() -> dict[str, Callable[..., Any]]:
    """All functions that the functions of `engines` call, directly or not, by module and name."""
    return functions_called(engines.FUNCTIONS.values())


def cache_folder() -> Path:
    """The cache folder of the functions compiled for this machine."""
    functions = [*engines.FUNCTIONS.values(), *compiled_functions().values()]
    return folder_of("step-check", functions, [sys.modules[__name__], engines, fairness, tables])


def _build(folder: Path) -> engines.Engine:
    """Compiles the functions for arrays."""
    import numba
    from numba import extending

    from kitrobot.sim.jit import numba_tables  # noqa: F401 (it tells Numba what a pointer to tables is)

    typeof: Any = numba.typeof
    # Numba's annotations know fewer options than Numba does.
    for function in compiled_functions().values():
        options: Any = {**CALLED, "forceinline": True} if function.__name__ in _INLINED else CALLED
        extending.register_jitable(**options)(function)
    made = dict(zip(engines.FUNCTIONS, njit(folder, engines.FUNCTIONS.values()), strict=True))
    entries = {}
    for name, arguments in samples().items():
        types = tuple(typeof(one) for one in arguments)
        made[name].compile(types)
        # The entry point skips Numba's dispatch on argument types, which takes longer than most calls.
        entries[name] = made[name].overloads[types].entry_point
    return engines.array_engine(entries)


def samples() -> dict[str, tuple[Any, ...]]:
    """Sample arguments of the exact types that each function gets: for others Numba would compile again, in a check."""
    import numpy as np

    words: Any = np.zeros(1, np.int64)
    numbers: Any = np.zeros(1, np.int32)
    marks: Any = np.zeros(1, np.uint8)
    kinds: dict[str, Any] = {"x": words, "y": words, "taken": np.zeros(1, np.uint16)}
    columns: list[Any] = [words] * len(engines.ArrayTables._fields)
    rows: list[Any] = [words if name in MASKS else numbers for name in ComponentSearch._fields]
    t = engines.ArrayTables(*columns).pointer
    g = engines.ArrayGraph(*(kinds.get(name, numbers) for name in engines.ArrayGraph._fields)).pointer
    s = TablePointer(ComponentSearch(*rows))
    b = TablePointer(StepBatch(words, words, words, words, numbers, numbers, numbers, numbers, marks, words, words))
    f = TablePointer(StateFilter(marks, marks, marks, words, words))
    return {
        "explore_states": (t, g, b, 1),
        "insert_steps": (g, b, 1, 1, 1, 1, 1, True),
        "number_steps": (t, g, b, 1),
        "filter_steps": (f, b, 1, 1, 1, 1, 1),
        "queue_steps": (t, g, b, f, 1),
        "expand": (t, 1, 1),
        "rehash": (g, 1, True),
        "repack": (g, 1, 1, words, words, True, True),
        "mark_states": (t, g, 1, 1, True, words, words, marks),
        "sense_agent": (t, g, 1, 1, True, 1, words),
        "find_crossing": (g, 1, 1, marks, marks),
        "prune_open_states": (g, numbers, 1, marks, marks),
        "find_fair_component": (t, g, s, 1),
        "mark_reachable": (g, marks, marks, numbers, numbers, numbers, words, 1),
        "sample_steps": (g, numbers, marks, numbers),
        "find_shortest_path": (g, 1, 1, marks, numbers, numbers),
    }


engine = Compilation(f"{__name__}:engine", cache_folder, _build)
