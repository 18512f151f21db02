"""Deadlock detection: whether nothing in the run can ever change again.

That is certain when the whole state of the run (machines, nothing moving, nothing on its way, and for so long that late
sensors have nothing new to tell) comes back as it was, nothing in it is left to chance, and nobody is to be revived on
schedule: from the same state follows the same future. States are compared with one that is kept and taken anew at ever
longer distances (Brent's way to find a cycle), so a program that only polls is detected too, whatever its period.

A robot that is held (its wheels turn, another one or a wall is in its way) moves nothing either: where it is and how
fast, and what its devices count, come out of the step as they went into it, to the bit. Whether that is so is looked
at now and then, and at each step once it was: comparing costs as much as moving.
"""

from __future__ import annotations

from kitrobot.sim.step.dispatch import AGREES, DRIVES, is_busy
from kitrobot.sim.tables.columns import (
    A_FRESH,
    A_KIND,
    A_OWN,
    A_QUEUED,
    A_ROBOT,
    AT,
    CHANCE,
    CYCLE,
    DISTANCE,
    DOWN,
    ENDED,
    FAILED,
    FAILS,
    HEADING,
    KEPT,
    PATIENCE,
    PLANNED,
    PLANS,
    QUIET,
    REVIVALS,
    ROLLING,
    SPEED,
    STUCK,
    TARGET,
    TICK,
    TURN,
    UNTIL,
    X,
    Y,
)
from kitrobot.sim.tables.rows import copy_row, same
from kitrobot.sim.tables.state import State
from kitrobot.sim.team.meetings import is_team_unchanged, save_team

QUIET_STEPS = 50
"""Steps without motion or command, besides what the latest sensor needs, before it is worth while to look."""

LOOK_EVERY = 32
"""Steps in which robots roll between two looks at whether they get anywhere."""

HELD_ROWS = 11
"""Rows of `held`: seven numbers of each robot, four of each actuator."""


def should_compare_motion(step: int, state: State) -> bool:
    """Whether it is worth while to look in this step whether all that roll are held.

    Never while a robot may still fail on schedule or by chance: who is held, and fails, lets go.
    """
    clock = state.clock
    if clock[ROLLING] == 0 or clock[PLANNED] < clock[PLANS]:
        return False
    if state.fixed_floats[FAILS] > 0.0 or clock[CHANCE] > 0:
        return False
    return clock[QUIET] > 0 or step % LOOK_EVERY == 0


def save_motion(state: State) -> None:
    """Keeps how robots and devices are before a step."""
    floats = state.robots.floats
    actuator_floats = state.actuators.floats
    held = state.held
    copy_row(held[0], floats[X])
    copy_row(held[1], floats[Y])
    copy_row(held[2], floats[HEADING])
    copy_row(held[3], floats[SPEED])
    copy_row(held[4], floats[TARGET])
    copy_row(held[5], floats[TURN])
    copy_row(held[6], floats[AT])
    for n in range(len(A_OWN)):
        copy_row(held[7 + n], actuator_floats[A_OWN[n]])


def is_motion_unchanged(state: State) -> bool:
    """Whether robots and devices are after a step as they were before it."""
    floats = state.robots.floats
    actuator_floats = state.actuators.floats
    held = state.held
    if not (same(floats[X], held[0]) and same(floats[Y], held[1]) and same(floats[HEADING], held[2])):
        return False
    if not (same(floats[SPEED], held[3]) and same(floats[TARGET], held[4]) and same(floats[TURN], held[5])):
        return False
    if not same(floats[AT], held[6]):
        return False
    n = 0
    while n < len(A_OWN) and same(actuator_floats[A_OWN[n]], held[7 + n]):
        n += 1
    return n == len(A_OWN)


def is_device_working(step: int, state: State) -> bool:
    """Whether a device was told something new in this step, has a command on its way, or does something that ends.

    What wheels do is not asked: that is in the numbers that `is_motion_unchanged` compares.
    """
    actuator = state.actuators.ints
    down = state.robots.ints[DOWN]
    for k in range(len(actuator[A_FRESH])):
        if actuator[A_FRESH][k] == step + 1 and AGREES[actuator[A_KIND][k]] == 0:
            return True
        if down[actuator[A_ROBOT][k]] == FAILED:
            continue
        if actuator[A_QUEUED][k] > 0 or (DRIVES[actuator[A_KIND][k]] == 0 and is_busy(k, state)):
            return True
    return False


def detect_deadlock(state: State) -> None:
    """Called after a step in which nothing stirred; sets STUCK when the state has come back."""
    clock = state.clock
    clock[QUIET] += 1
    if clock[QUIET] < clock[PATIENCE] or clock[TICK] % clock[CYCLE] != 0 or clock[CHANCE] > 0 or clock[REVIVALS] > 0:
        return
    machines = state.machines
    cells = machines.cells
    threads = machines.threads
    pars = machines.pars
    kept_cells = machines.kept_cells
    kept_threads = machines.kept_threads
    kept_pars = machines.kept_pars
    ended = state.robots.ints[ENDED]
    if clock[KEPT] == 0 or clock[DISTANCE] >= clock[UNTIL]:
        clock[UNTIL] = 1 if clock[KEPT] == 0 else 2 * clock[UNTIL]
        clock[DISTANCE] = 0
        clock[KEPT] = 1
        for i in range(len(ended)):
            if ended[i] == 0:
                copy_row(kept_cells[i], cells[i])
                copy_row(kept_threads[i], threads[i])
                copy_row(kept_pars[i], pars[i])
        save_team(state.team)
        return
    clock[DISTANCE] += 1
    if not is_team_unchanged(state.team):
        return
    for i in range(len(ended)):
        if ended[i] == 0 and not (
            same(threads[i], kept_threads[i]) and same(cells[i], kept_cells[i]) and same(pars[i], kept_pars[i])
        ):
            return
    clock[STUCK] = 1


def mark_activity(clock: list[int]) -> None:
    """Something moved, was said, or was done from outside: nothing is stuck, and the search begins anew."""
    clock[QUIET] = 0
    clock[KEPT] = 0
    clock[STUCK] = 0
