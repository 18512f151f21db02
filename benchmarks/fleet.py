"""Many robots, many ticks, in one compiled call: the very `tick` of every host under Numba, and the loop around it.

Each row of `cells`, `threads`, `pars` and `out` is one robot. A robot whose program has ended begins it anew, so that
there is always work. Rows are taken out once a robot and not once a tick: that counts references.
"""

from __future__ import annotations

from numba import njit

from kitrobot_onboard.interpreter import tick

_tick = njit(nogil=True)(tick)


@njit(nogil=True)
def drive(code, cells, threads, pars, out, seen, first, ticks):
    """Runs every robot for so many ticks; gives how many programs ended. `first`: cells and threads at the start."""
    ended = 0
    first_cells, first_threads = first
    for robot in range(cells.shape[0]):
        its_cells = cells[robot]
        its_threads = threads[robot]
        its_pars = pars[robot]
        its_out = out[robot]
        for _ in range(ticks):
            _tick(code, its_cells, its_threads, its_pars, its_out, seen)
            if its_threads[0] < 0:
                ended += 1
                its_cells[:] = first_cells
                its_threads[:] = first_threads
    return ended
