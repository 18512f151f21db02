"""What a person does to a run: values in the place of what sensors measure, and the emergency stop."""

from __future__ import annotations

from kitrobot.sim.step.deadlock_detection import mark_activity
from kitrobot.sim.tables.columns import (
    CHANCE,
    ROLLING,
    S_DROPOUT,
    S_FORCE,
    S_FORCED,
    S_NOISE,
    S_PLAIN,
    S_RESTLESS,
    S_SIZE,
    SAVED_TARGET,
    SPEED,
    TARGET,
    TURN,
    WAY,
)
from kitrobot.sim.tables.state import State

MOST = 2**40
"""A noise of ten million or a forced value beyond all range would not fit the tables."""


def force_sensor(k: int, value: int | None, state: State) -> None:
    """From the next step on, `value` is what sensor k reads; None gives it back."""
    table, clock = state.sensors.ints, state.clock
    by_chance = state.sensors.floats[S_NOISE][k] > 0 or state.sensors.floats[S_DROPOUT][k] > 0
    was_forced, is_forced = bool(table[S_FORCED][k]), value is not None
    if table[S_RESTLESS][k] and was_forced != is_forced:
        clock[CHANCE] += -1 if is_forced else 1
    table[S_FORCED][k] = 1 if is_forced else 0
    table[S_FORCE][k] = max(-MOST, min(MOST, value)) if value is not None else 0
    table[S_PLAIN][k] = 1 if not is_forced and table[S_SIZE][k] == 1 and not by_chance else 0
    mark_activity(clock)


def stop_motors(state: State) -> None:
    """Every robot stands still at once."""
    floats = state.robots.floats
    for column in (SPEED, TARGET, SAVED_TARGET, TURN, WAY):
        floats[column][:] = [0.0] * len(floats[column])
    state.clock[ROLLING] = 0
