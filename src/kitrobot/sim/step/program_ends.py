"""The end of a robot's program, and what the run as a whole counts of it."""

from __future__ import annotations

from kitrobot.sim.tables.columns import END, ENDED, HEALTHY, LIVING, MUTED, RUNNING, record_event
from kitrobot.sim.tables.state import State


def end_program(i: int, state: State) -> None:
    """The program of robot i, which has not failed, is at its end."""
    clock = state.clock
    ints = state.robots.ints
    ints[ENDED][i] = 1
    clock[RUNNING] -= 1
    clock[LIVING] -= 1
    if ints[MUTED][i] == 0:
        clock[HEALTHY] -= 1
    record_event(state.events, clock, END, i, 0, 0)
