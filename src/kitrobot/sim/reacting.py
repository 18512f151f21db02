"""The machines' ticks: every program that is due reacts once, in team order, and its commands go on their way.

The one interpreter runs them. A tick is a function of the machine's state alone; so when one gave no command and left
everything as it found it, the next would do the same, and the machine sleeps until one of its inputs changes.
"""

from __future__ import annotations

from kitrobot.sim.columns import ASLEEP, DOWN, END, ENDED, LIVING, MUTED, PERIOD, PROGRAM, RUNNING, SOUND, WIRES, tell
from kitrobot.sim.commanding import give
from kitrobot.sim.rows import copy_row, same
from kitrobot_onboard.interpreter import tick


def react(
    step: int,
    whole: list[list[int]],
    code: list[list[int]],
    commands: list[list[int]],
    parts: list[int],
    cells: list[list[int]],
    threads: list[list[int]],
    pars: list[list[int]],
    out: list[list[int]],
    seen: list[list[int]],
    was_cells: list[int],
    was_threads: list[int],
    was_pars: list[int],
    wires: list[int],
    takens: list[list[int]],
    actuator: list[list[int]],
    actuator_real: list[list[float]],
    real: list[list[float]],
    faces: list[list[int]],
    queue: list[int],
    events: list[int],
    clock: list[int],
) -> int:
    """One tick of every program that is due and awake; gives how many ran. `parts` is a program's actuators."""
    ended = whole[ENDED]
    asleep = whole[ASLEEP]
    down = whole[DOWN]
    period = whole[PERIOD]
    program = whole[PROGRAM]
    ran = 0
    for i in range(len(ended)):
        if asleep[i] or ended[i] or down[i] or step % period[i]:
            continue
        ran += 1
        p = program[i]
        its_cells = cells[i]
        its_threads = threads[i]
        its_pars = pars[i]
        its_out = out[i]
        copy_row(was_cells, its_cells)
        copy_row(was_threads, its_threads)
        copy_row(was_pars, its_pars)
        its_seen = seen[i]
        for number in range(len(its_seen)):
            its_seen[number] = 0
        tick(code[p], its_cells, its_threads, its_pars, its_out, its_seen)
        width = its_pars[3]
        quiet = True
        for number in range(parts[p]):
            if its_out[number * width]:
                quiet = False
                k = wires[whole[WIRES][i] + number]
                give(
                    step,
                    k,
                    its_out[number * width + 2],
                    its_out,
                    number * width + 3,
                    commands[p],
                    takens[k],
                    actuator,
                    actuator_real,
                    real,
                    whole,
                    faces,
                    queue,
                    events,
                    clock,
                )
        if its_threads[0] < 0:
            ended[i] = 1
            clock[RUNNING] -= 1
            clock[LIVING] -= 1
            if whole[MUTED][i] == 0:
                clock[SOUND] -= 1
            tell(events, clock, END, i, 0, 0)
        elif quiet and same(its_threads, was_threads) and same(its_cells, was_cells) and same(its_pars, was_pars):
            asleep[i] = 1
    return ran
