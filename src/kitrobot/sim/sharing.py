"""Shared variables in a step: every agent has a copy, a write carries a logical clock, the latest write wins.

What an agent writes in a tick reaches all others before their next tick. A write is stamped one later than the newest
the writer has seen; of two with the same stamp the one of the agent that stands later in the team wins, as if they
had written one after the other. Everybody hears of every write at once, so all copies agree between steps. Writing the
value that is there already is no write.

The rows of `shared`: the value that holds, its clock and its writer, where its copies begin in `copy_robot` and
`copy_cell`, where they end, and room for the writer of this step. Robot i has the variables `mine[k]` in its cells
`mine_cell[k]` for k from `mine_first[i]` to `mine_first[i + 1]` - 1.
"""

from __future__ import annotations

from kitrobot.sim.columns import ASLEEP, PERIOD, WRITTEN, tell

SHARED_VALUE, SHARED_CLOCK, SHARED_WRITER, COPIES_FIRST, COPIES_LAST, WRITING = range(6)
SHARED_ROWS = 6


def exchange(
    step: int,
    whole: list[list[int]],
    cells: list[list[int]],
    shared: list[list[int]],
    mine_first: list[int],
    mine: list[int],
    mine_cell: list[int],
    copy_robot: list[int],
    copy_cell: list[int],
    events: list[int],
    clock: list[int],
) -> None:
    """Spreads what was written in this step."""
    values = shared[SHARED_VALUE]
    writing = shared[WRITING]
    asleep = whole[ASLEEP]
    period = whole[PERIOD]
    written = 0
    for i in range(len(asleep)):
        first = mine_first[i]
        last = mine_first[i + 1]
        # Who sleeps has written nothing.
        if first == last or asleep[i] or step % period[i]:
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
        shared[SHARED_CLOCK][v] += 1
        shared[SHARED_WRITER][v] = i
        for k in range(shared[COPIES_FIRST][v], shared[COPIES_LAST][v]):
            j = copy_robot[k]
            if cells[j][copy_cell[k]] != values[v]:
                cells[j][copy_cell[k]] = values[v]
                asleep[j] = 0
        tell(events, clock, WRITTEN, i, v, values[v])
