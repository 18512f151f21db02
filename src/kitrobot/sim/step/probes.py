"""Probes: numbers of a run that are read after each step, so that many steps in one call can be measured.

A place of a whole number is its table (`OF_CELLS` …), its row and its column; one of a number with a fraction is its
row and column in `robots.floats`. Reading changes nothing that a step looks at. It begins with `begin_probes`; from
then on `step_loop` runs no more steps than there is room for.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from kitrobot.sim.tables.state import Probes, State

OF_ROBOTS, OF_CELLS, OF_ACTUATORS, OF_TAKENS, OF_TEAM_ROBOTS, OF_TEAM_GROUPS = range(6)
"""Tables: robots.ints, machines.cells, actuators.ints, actuators.takens, team.robots, team.groups."""

PROBES_OFF = -1
"""The count where nothing is read."""

IntPlace = tuple[int, int, int]
FloatPlace = tuple[int, int]

_MOST_STEPS, _MOST_NUMBERS = 500, 200_000
"""Room: for so many steps, or fewer where that would be more numbers."""


def no_probes() -> Probes:
    """The tables of a run that nobody probes."""
    return probe_tables((), ())


def probe_tables(ints: Sequence[IntPlace], floats: Sequence[FloatPlace]) -> Probes:
    """Room for what is read at these places."""
    many = len(ints) + len(floats)
    room = max(1, min(_MOST_STEPS, _MOST_NUMBERS // many)) if many else 0
    return Probes(
        count=[PROBES_OFF],
        int_places=[list(column) for column in zip(*ints, strict=True)] or [[], [], []],
        float_places=[list(column) for column in zip(*floats, strict=True)] or [[], []],
        ints=[[0] * len(ints) for _ in range(room)],
        floats=[[0.0] * len(floats) for _ in range(room)],
    )


def begin_probes(state: State) -> None:
    """From the next step on the numbers are read."""
    state.probes.count[0] = 0


def take_probed(state: State) -> tuple[list[list[int]], list[list[float]]]:
    """What was written down since it was taken last: of each place its numbers, one a step."""
    probes = state.probes
    count = int(probes.count[0])
    probes.count[0] = 0
    return _columns(probes.ints, count), _columns(probes.floats, count)


def _columns(rows: Any, count: int) -> list[list[Any]]:
    if not isinstance(rows, list):
        return rows[:count].T.tolist()  # type: ignore[no-any-return]
    return [list(column) for column in zip(*rows[:count], strict=True)]


def read_probes(state: State) -> None:
    """Writes down the numbers as they are now; there is room."""
    probes = state.probes
    count = probes.count[0]
    whole = probes.ints[count]
    tables = probes.int_places[0]
    rows = probes.int_places[1]
    columns = probes.int_places[2]
    for k in range(len(tables)):
        table = tables[k]
        row = rows[k]
        column = columns[k]
        if table == OF_CELLS:
            whole[k] = state.machines.cells[row][column]
        elif table == OF_ROBOTS:
            whole[k] = state.robots.ints[row][column]
        elif table == OF_ACTUATORS:
            whole[k] = state.actuators.ints[row][column]
        elif table == OF_TAKENS:
            whole[k] = state.actuators.takens[row][column]
        elif table == OF_TEAM_ROBOTS:
            whole[k] = state.team.robots[row][column]
        else:
            whole[k] = state.team.groups[row][column]
    real = probes.floats[count]
    rows = probes.float_places[0]
    columns = probes.float_places[1]
    for k in range(len(rows)):
        real[k] = state.robots.floats[rows[k]][columns[k]]
    probes.count[0] = count + 1
