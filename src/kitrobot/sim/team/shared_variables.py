"""Shared variables in a step: every agent has a copy, a write carries a logical clock, the latest write wins.

What an agent writes in a tick reaches all others before their next tick. A write is stamped one later than the newest
the writer has seen; of two with the same stamp the one of the agent that stands later in the team wins, as if they
had written one after the other. Everybody hears of every write at once, so all copies agree between steps. Writing the
value that is there already is no write.

Who has no radio (muted, or failed) is apart: it neither hears nor is heard, and stamps what it writes by itself. When
it is back, the latest write wins as ever: either all others take its value, or it takes theirs.

The rows of `shared.ints`: the value that holds, its clock and its writer, where its copies begin in `copy_robot` and
`copy_cell`, where they end, and room for the writer of this step. Robot i has the variables `mine[k]` in its cells
`mine_cell[k]` for k from `mine_first[i]` to `mine_first[i + 1]` - 1; the rows of `apart` say what it knows of each, as
long as it is apart: value, clock and writer.
"""

from __future__ import annotations

from kitrobot.sim.tables.columns import ASLEEP, DOWN, FAILED, MUTED, PERIOD, WRITTEN, record_event
from kitrobot.sim.tables.state import IntRows, Robots, SharedVariables, State

SHARED_VALUE, SHARED_CLOCK, SHARED_WRITER, COPIES_FIRST, COPIES_LAST, WRITING = range(6)
SHARED_ROWS = 6
APART_VALUE, APART_CLOCK, APART_WRITER = range(3)
APART_ROWS = 3


def exchange(step: int, state: State) -> None:
    """Spreads what was written in this step."""
    ints = state.robots.ints
    cells = state.machines.cells
    shared = state.shared
    mine_first = shared.mine_first
    mine = shared.mine
    mine_cell = shared.mine_cell
    table = shared.ints
    values = table[SHARED_VALUE]
    writing = table[WRITING]
    asleep = ints[ASLEEP]
    period = ints[PERIOD]
    down = ints[DOWN]
    muted = ints[MUTED]
    written = 0
    for i in range(len(asleep)):
        first = mine_first[i]
        last = mine_first[i + 1]
        # Who sleeps has written nothing.
        if first == last or asleep[i] or step % period[i]:
            continue
        if muted[i] or down[i] == FAILED:
            note(i, False, state)
            continue
        row = cells[i]
        for k in range(first, last):
            if row[mine_cell[k]] != values[mine[k]]:
                writing[mine[k]] = i
                written += 1
    if written == 0:
        return
    for v in range(len(values)):
        i = writing[v]
        if i < 0:
            continue
        writing[v] = -1
        for k in range(mine_first[i], mine_first[i + 1]):
            if mine[k] == v:
                values[v] = cells[i][mine_cell[k]]
        table[SHARED_CLOCK][v] += 1
        table[SHARED_WRITER][v] = i
        spread(v, state.robots, cells, shared)
        record_event(state.events, state.clock, WRITTEN, i, v, values[v])


def spread(v: int, robots: Robots, cells: IntRows, shared: SharedVariables) -> None:
    """Gives the value of variable v to all who hear."""
    ints = robots.ints
    copy_robot = shared.copy_robot
    copy_cell = shared.copy_cell
    table = shared.ints
    value = table[SHARED_VALUE][v]
    down = ints[DOWN]
    muted = ints[MUTED]
    for k in range(table[COPIES_FIRST][v], table[COPIES_LAST][v]):
        j = copy_robot[k]
        if muted[j] == 0 and down[j] != FAILED and cells[j][copy_cell[k]] != value:
            cells[j][copy_cell[k]] = value
            ints[ASLEEP][j] = 0


def note(i: int, tells: bool, state: State) -> bool:
    """Stamps what robot i wrote by itself, and tells it where that is wanted; whether it wrote anything."""
    shared = state.shared
    apart = shared.apart
    cells = state.machines.cells[i]
    wrote = False
    for k in range(shared.mine_first[i], shared.mine_first[i + 1]):
        value = cells[shared.mine_cell[k]]
        if value != apart[APART_VALUE][k]:
            apart[APART_VALUE][k] = value
            apart[APART_CLOCK][k] += 1
            apart[APART_WRITER][k] = i
            wrote = True
            if tells:
                record_event(state.events, state.clock, WRITTEN, i, shared.mine[k], value)
    return wrote


def leave(i: int, shared: SharedVariables) -> None:
    """Robot i loses its radio: it knows what held until now."""
    apart = shared.apart
    for k in range(shared.mine_first[i], shared.mine_first[i + 1]):
        v = shared.mine[k]
        apart[APART_VALUE][k] = shared.ints[SHARED_VALUE][v]
        apart[APART_CLOCK][k] = shared.ints[SHARED_CLOCK][v]
        apart[APART_WRITER][k] = shared.ints[SHARED_WRITER][v]


def rejoin(i: int, state: State) -> None:
    """Robot i has its radio again: of each variable the latest write wins."""
    cells = state.machines.cells
    shared = state.shared
    apart = shared.apart
    mine_cell = shared.mine_cell
    note(i, False, state)
    for k in range(shared.mine_first[i], shared.mine_first[i + 1]):
        v = shared.mine[k]
        stamp = apart[APART_CLOCK][k]
        newest = shared.ints[SHARED_CLOCK][v]
        if stamp > newest or (stamp == newest and apart[APART_WRITER][k] > shared.ints[SHARED_WRITER][v]):
            shared.ints[SHARED_CLOCK][v] = stamp
            shared.ints[SHARED_WRITER][v] = apart[APART_WRITER][k]
            if apart[APART_VALUE][k] != shared.ints[SHARED_VALUE][v]:
                shared.ints[SHARED_VALUE][v] = apart[APART_VALUE][k]
                spread(v, state.robots, cells, shared)
                record_event(state.events, state.clock, WRITTEN, i, v, apart[APART_VALUE][k])
        elif cells[i][mine_cell[k]] != shared.ints[SHARED_VALUE][v]:
            cells[i][mine_cell[k]] = shared.ints[SHARED_VALUE][v]
            state.robots.ints[ASLEEP][i] = 0
