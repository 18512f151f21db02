"""Tables of the radio before the first step."""

from __future__ import annotations

import math
from collections.abc import Sequence

from kitrobot.mission.radio import Radio as RadioOfMission
from kitrobot.sim.setup.shared_tables import SharedTables
from kitrobot.sim.tables.state import Grid, Radio
from kitrobot.sim.team import radio as r
from kitrobot.sim.team.shared_variables import APART_ROWS, APART_VALUE, APART_WRITER

BEAT_MS = 125
"""From one message that a robot sends in any case to the next."""


def no_radio() -> Radio:
    """The tables of a run in which everybody hears everybody at once."""
    return Radio([], [], [[] for _ in range(r.RADIO_ROWS)], [[], []], [], [[] for _ in range(APART_ROWS)], _grid(0))


def _grid(count: int) -> Grid:
    """One cell with all robots in it, and room for more cells."""
    return Grid([0.0, 0.0, math.inf], [1, 1], [0, count] + [0] * (2 * count + 4), list(range(count)))


def beat_steps(step_ms: float) -> int:
    """Steps from one beat to the next."""
    return max(1, round(BEAT_MS / step_ms))


def delay_steps(radio: RadioOfMission, step_ms: float) -> int:
    """Steps that a message takes."""
    return math.ceil(radio.delay_ms / step_ms - 1e-9)


def radio_tables(
    radio: RadioOfMission | None,
    names: Sequence[str],
    periods: Sequence[int],
    step_ms: float,
    shared: SharedTables,
) -> Radio:
    """The tables for the robots of a run, and what each knows of shared variables at the start.

    Args:
        radio: of the mission; None for none.
        names: of the robots.
        periods: steps from one tick of each robot to its next.
        step_ms: a step of the run.
        shared: its rows `apart` are filled in.
    """
    if radio is None:
        return no_radio()
    tables = shared.tables
    tables.apart[APART_VALUE][:] = [shared.variables[v].initial for v in tables.mine]
    tables.apart[APART_WRITER][:] = [-1] * len(tables.mine)
    delay, beat = delay_steps(radio, step_ms), beat_steps(step_ms)
    rows = [[0] * len(names) for _ in range(r.RADIO_ROWS)]
    slots = room = 0
    for i, period in enumerate(periods):
        count = tables.mine_first[i + 1] - tables.mine_first[i]
        rows[r.QUORUM][i] = 1
        rows[r.SLOTS_FIRST][i], rows[r.AIR_FIRST][i] = slots, room
        rows[r.SLOTS][i] = delay // period + delay // beat + 3
        slots += rows[r.SLOTS][i]
        room += rows[r.SLOTS][i] * count
    return Radio(
        numbers=[delay, beat, 1, 1],
        floats=[math.inf if radio.range_mm is None else radio.range_mm, radio.loss / 100],
        robots=rows,
        keys=[[0] * len(names), [0] * len(names)],
        due=[0] * slots,
        air=[[0] * room for _ in range(APART_ROWS)],
        grid=_grid(len(names)),
    )
