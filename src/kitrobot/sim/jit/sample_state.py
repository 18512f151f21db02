"""A state that has a little of everything in the tables' right kinds: for Numba to see what it compiles for."""

from __future__ import annotations

from kitrobot.sim.jit.arrays import ArrayState, as_arrays
from kitrobot.sim.setup.initial_state import Tables
from kitrobot.sim.setup.shared_tables import SharedTables
from kitrobot.world.model import World


def small_state() -> ArrayState:
    """The state of a run without robots; its step does nothing."""
    return as_arrays(Tables(World("nowhere", 1.0, 1.0), 20).state(SharedTables([])))
