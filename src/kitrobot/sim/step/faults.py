"""Fault injection: crash, stall, radio loss and recovery of robots, on schedule and by chance.

*Failed*: it stops reacting for good. Its wheels brake as at `Stop()`, its other devices stand as they are, and it stays
where it is, in everybody's way, unless the mission says what becomes of it on a road (breakdowns). *Stalled*: its
program misses its ticks; the devices continue with their last commands.
*Muted*: it has lost its radio, as a failed one has: shared variables neither come nor go (`shared_variables`).
*Apart*, in a mission with a radio: it hears only others that are apart too. *Revived*: all of that is over; program and
devices go on where they were.

The schedule is rows of `plan`: step, robot and kind, in order of steps; PLANS of them count. By chance a robot fails
with the same probability in every second of its own; the draws are counted by the step, so they need no state. From
outside, between two steps, `Simulation.inject_fault` calls `inject_fault` here.
"""

from __future__ import annotations

from kitrobot.sim.step.breakdowns import count_breakdowns, end_breakdown, may_be_revived
from kitrobot.sim.step.deadlock_detection import mark_activity
from kitrobot.sim.tables.columns import (
    ASLEEP,
    CAUSE,
    DOWN,
    ENDED,
    FAILED,
    FAILS,
    FAILS_EVERY,
    FAULT,
    HEALTHY,
    LIVING,
    MUTED,
    PLANNED,
    PLANS,
    REVIVALS,
    SAVED_TARGET,
    SINCE,
    STALLED,
    TARGET,
    TICK,
    TURN,
    WELL,
    record_event,
)
from kitrobot.sim.tables.random_numbers import happens
from kitrobot.sim.tables.state import State
from kitrobot.sim.team.radio import SIDE, has_radio
from kitrobot.sim.team.shared_variables import leave, rejoin

FAIL, STALL, MUTE, REVIVE, APART = range(5)
"""Kinds of faults, in the order of `FailureKind`."""

BY_HAND, ON_SCHEDULE, BY_CHANCE, AWAY, HELD = range(5)

PLAN_STEP, PLAN_ROBOT, PLAN_KIND = range(3)
PLAN_ROWS = 3


def inject_fault(i: int, kind: int, cause: int, state: State) -> None:
    """Applies a fault to robot i and records the event; a fault that would change nothing is not recorded."""
    floats = state.robots.floats
    ints = state.robots.ints
    clock = state.clock
    down = ints[DOWN]
    muted = ints[MUTED]
    was_deaf = muted[i] != 0 or down[i] == FAILED
    was_sound = muted[i] == 0 and down[i] == WELL
    if kind == FAIL:
        if down[i] == FAILED:
            return
        down[i] = FAILED
        floats[SAVED_TARGET][i] = floats[TARGET][i]
        floats[TARGET][i] = 0.0
        floats[TURN][i] = 0.0
        if ints[ENDED][i] == 0:
            clock[LIVING] -= 1
        count_breakdowns(state)
    elif kind == STALL:
        if down[i] != WELL:
            return
        down[i] = STALLED
    elif kind == MUTE:
        if muted[i]:
            return
        muted[i] = 1
    elif kind == APART:
        if not has_radio(state) or state.radio.robots[SIDE][i]:
            return
        state.radio.robots[SIDE][i] = 1
    else:
        is_apart = has_radio(state) and state.radio.robots[SIDE][i] != 0
        if (down[i] == WELL and muted[i] == 0 and not is_apart) or not may_be_revived(i, state):
            return
        if is_apart:
            state.radio.robots[SIDE][i] = 0
        had_failed = down[i] == FAILED
        down[i] = WELL
        if had_failed:
            end_breakdown(i, state)
            floats[TARGET][i] = floats[SAVED_TARGET][i]
            if ints[ENDED][i] == 0:
                clock[LIVING] += 1
        muted[i] = 0
        ints[ASLEEP][i] = 0
    if kind != MUTE and kind != APART:
        ints[SINCE][i] = clock[TICK]
        ints[CAUSE][i] = cause
    mark_activity(clock)
    record_event(state.events, clock, FAULT, i, kind, cause)
    if ints[ENDED][i] == 0:
        if was_sound:
            clock[HEALTHY] -= 1
        if muted[i] == 0 and down[i] == WELL:
            clock[HEALTHY] += 1
    is_deaf = muted[i] != 0 or down[i] == FAILED
    if has_radio(state):
        return
    if is_deaf and not was_deaf:
        leave(i, state.shared)
    elif was_deaf and not is_deaf:
        rejoin(i, state)


def inject_scheduled_faults(step: int, state: State) -> None:
    """Injects the faults that are scheduled for this step."""
    clock = state.clock
    plan = state.faults.plan
    steps = plan[PLAN_STEP]
    while clock[PLANNED] < clock[PLANS] and steps[clock[PLANNED]] <= step:
        n = clock[PLANNED]
        clock[PLANNED] = n + 1
        kind = plan[PLAN_KIND][n]
        if kind == REVIVE:
            clock[REVIVALS] -= 1
        inject_fault(plan[PLAN_ROBOT][n], kind, ON_SCHEDULE, state)


def inject_random_faults(step: int, state: State) -> None:
    """Lets the robots whose turn it is fail by chance; each has its turn in one of FAILS_EVERY steps.

    `fate` is two rows: the two keys of each robot.
    """
    every = state.fixed[FAILS_EVERY]
    probability = state.fixed_floats[FAILS]
    fate = state.faults.fate
    ints = state.robots.ints
    down = ints[DOWN]
    ended = ints[ENDED]
    for i in range(step % every, len(down), every):
        if down[i] == FAILED or ended[i] or not happens(fate[0][i], fate[1][i], step, probability):
            continue
        inject_fault(i, FAIL, BY_CHANCE, state)
