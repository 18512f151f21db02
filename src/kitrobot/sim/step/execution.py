"""Execution: runs one tick of every machine that is due, in team order, and passes its commands to actuation.

A tick is a function of the machine's state alone. When it gave no command and changed nothing, the next one would do
the same, so the machine sleeps until one of its inputs changes.
"""

from __future__ import annotations

from kitrobot.sim.step.actuation import issue_command
from kitrobot.sim.step.program_ends import end_program
from kitrobot.sim.tables.columns import ACTUATOR_INDEX, ASLEEP, DOWN, ENDED, PERIOD, PROGRAM
from kitrobot.sim.tables.rows import copy_row, same
from kitrobot.sim.tables.state import State
from kitrobot_onboard.interpreter import tick


def react(step: int, state: State) -> int:
    """One tick of every program that is due and awake; gives how many ran."""
    machines = state.machines
    was_cells = machines.was_cells
    was_threads = machines.was_threads
    was_pars = machines.was_pars
    parts = machines.parts
    actuator_index = state.actuators.actuator_index
    ints = state.robots.ints
    ended = ints[ENDED]
    asleep = ints[ASLEEP]
    down = ints[DOWN]
    period = ints[PERIOD]
    program = ints[PROGRAM]
    ran = 0
    for i in range(len(ended)):
        if asleep[i] or ended[i] or down[i] or step % period[i]:
            continue
        ran += 1
        p = program[i]
        its_cells = machines.cells[i]
        its_threads = machines.threads[i]
        its_pars = machines.pars[i]
        its_out = machines.out[i]
        copy_row(was_cells, its_cells)
        copy_row(was_threads, its_threads)
        copy_row(was_pars, its_pars)
        its_seen = machines.seen[i]
        for number in range(len(its_seen)):
            its_seen[number] = 0
        tick(machines.code[p], its_cells, its_threads, its_pars, its_out, its_seen)
        width = its_pars[3]
        quiet = True
        for number in range(parts[p]):
            if its_out[number * width]:
                quiet = False
                k = actuator_index[ints[ACTUATOR_INDEX][i] + number]
                at = number * width
                issue_command(step, k, its_out[at + 2], its_out, at + 3, machines.commands[p], state)
        if its_threads[0] < 0:
            end_program(i, state)
        elif quiet and same(its_threads, was_threads) and same(its_cells, was_cells) and same(its_pars, was_pars):
            asleep[i] = 1
    return ran
