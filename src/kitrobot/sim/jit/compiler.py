"""The compiled step: `step_loop.advance` through Numba (see `jit_cache`)."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

from kitrobot.sim.jit.cache import CALLED, Compilation, folder_of, functions_called, njit

Advance = Callable[[Any, int], int]


def loops() -> dict[str, Callable[..., Any]]:
    """Every function that the step is made of, by the name of its module and its own."""
    from kitrobot.sim.step.step_loop import advance

    return functions_called([advance])


def cache_folder() -> Path:
    """Where this step is kept, compiled for this machine."""
    from kitrobot.sim.devices import base
    from kitrobot.sim.jit import arrays
    from kitrobot.sim.step import dispatch, step_loop
    from kitrobot.sim.tables import state

    functions = [step_loop.advance, *loops().values()]
    return folder_of("step", functions, [sys.modules[__name__], arrays, base, state], dispatch.SOURCE)


def _build(folder: Path) -> Advance:
    """`advance` as a function of Numba's, which has been told everything that it calls."""
    from numba import extending

    from kitrobot.sim.jit import numba_tables  # noqa: F401 (it tells Numba what a pointer to tables is)
    from kitrobot.sim.jit.sample_state import small_state
    from kitrobot.sim.step.step_loop import advance
    from kitrobot.sim.tables import rows

    def same_arrays(one: Any, other: Any) -> Any:
        def same(one: Any, other: Any) -> bool:
            k = 0
            while k < len(one) and one[k] == other[k]:
                k += 1
            return k == len(one)

        return same

    def copy_arrays(to: Any, row: Any) -> Any:
        def copy_row(to: Any, row: Any) -> None:
            for k in range(len(row)):
                to[k] = row[k]

        return copy_row

    # Numba's annotations know fewer options than Numba does.
    options: Any = CALLED
    extending.overload(rows.same, jit_options=options)(same_arrays)
    extending.overload(rows.copy_row, jit_options=options)(copy_arrays)
    for loop in loops().values():
        if loop.__module__ != rows.__name__:
            extending.register_jitable(**options)(loop)
    (compiled,) = njit(folder, [advance])
    compiled(small_state().pointer, 0)
    # Which of its versions is meant, Numba would find out at each call: that takes as long as some steps.
    (only,) = compiled.overloads.values()
    entry = only.entry_point

    def step(state: Any, steps: int) -> int:
        return int(entry(state.pointer, steps))

    step(small_state(), 0)
    return step


step = Compilation(f"{__name__}:step", cache_folder, _build)
