"""Finds out that nothing can ever change again.

It is certain when the whole state of the run (machines, nothing moving, nothing on its way, and for so long that late
sensors have nothing new to tell) comes back as it was, nothing in it is left to chance, and nobody is to be revived on
schedule: from the same state follows the same future. States are compared with one that is kept and taken anew at ever
longer distances (Brent's way to find a cycle), so a program that only polls is found out too, whatever its period.
"""

from __future__ import annotations

from kitrobot.sim.columns import CHANCE, CYCLE, DISTANCE, ENDED, KEPT, PATIENCE, QUIET, REVIVALS, STUCK, TICK, UNTIL
from kitrobot.sim.rows import copy_row, same

QUIET_STEPS = 50
"""Steps without motion or command, besides what the latest sensor needs, before it is worth while to look."""


def look_for_standstill(
    whole: list[list[int]],
    cells: list[list[int]],
    threads: list[list[int]],
    pars: list[list[int]],
    kept_cells: list[list[int]],
    kept_threads: list[list[int]],
    kept_pars: list[list[int]],
    clock: list[int],
) -> None:
    """Called after a step in which nothing stirred; sets STUCK when the state has come back."""
    clock[QUIET] += 1
    if clock[QUIET] < clock[PATIENCE] or clock[TICK] % clock[CYCLE] != 0 or clock[CHANCE] > 0 or clock[REVIVALS] > 0:
        return
    ended = whole[ENDED]
    if clock[KEPT] == 0 or clock[DISTANCE] >= clock[UNTIL]:
        clock[UNTIL] = 1 if clock[KEPT] == 0 else 2 * clock[UNTIL]
        clock[DISTANCE] = 0
        clock[KEPT] = 1
        for i in range(len(ended)):
            if ended[i] == 0:
                copy_row(kept_cells[i], cells[i])
                copy_row(kept_threads[i], threads[i])
                copy_row(kept_pars[i], pars[i])
        return
    clock[DISTANCE] += 1
    for i in range(len(ended)):
        if ended[i] == 0 and not (
            same(threads[i], kept_threads[i]) and same(cells[i], kept_cells[i]) and same(pars[i], kept_pars[i])
        ):
            return
    clock[STUCK] = 1


def stirred(clock: list[int]) -> None:
    """Something moved or was said: the search begins anew."""
    clock[QUIET] = 0
    clock[KEPT] = 0
