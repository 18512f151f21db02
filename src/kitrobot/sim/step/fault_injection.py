"""Fault injection: crash, stall, radio loss and recovery of robots, on schedule and by chance.

*Failed*: it stops reacting for good. Its wheels brake as at `Stop()`, its other devices stand as they are, and it stays
where it is, in everybody's way, unless the mission says what becomes of it on a road (failed_robots). *Stalled*: its
program misses its ticks; the devices continue with their last commands.
*Muted*: it has lost its radio, as a failed one has: shared variables neither come nor go (`shared_variables`).
*Apart*, in a mission with a radio: it hears only others that are apart too. *Revived*: all of that is over; program and
devices go on where they were.

The schedule is rows of `plan`: step, robot and kind, in order of steps; PLANS of them count. By chance a robot fails
with the same probability in every second of its own; the draws are counted by the step, so they need no state. From
outside, between two steps, `Simulation.inject_fault` calls `inject_fault` here.
"""

from __future__ import annotations

from kitrobot.sim.step.deadlock_detection import mark_activity
from kitrobot.sim.step.failed_robots import count_breakdowns, end_breakdown, may_be_revived
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
    ints = state.robots.ints
    clock = state.clock
    was_deaf = is_deaf(i, state)
    was_sound = is_sound(i, state)
    if not change_condition(i, kind, state):
        return
    if kind != MUTE and kind != APART:
        ints[SINCE][i] = clock[TICK]
        ints[CAUSE][i] = cause
    mark_activity(clock)
    record_event(state.events, clock, FAULT, i, kind, cause)
    if ints[ENDED][i] == 0:
        if was_sound:
            clock[HEALTHY] -= 1
        if is_sound(i, state):
            clock[HEALTHY] += 1
    if has_radio(state):
        return
    if not was_deaf and is_deaf(i, state):
        leave(i, state.shared)
    elif was_deaf and not is_deaf(i, state):
        rejoin(i, state)


def is_deaf(i: int, state: State) -> bool:
    """Whether robot i has no radio."""
    return state.robots.ints[MUTED][i] != 0 or state.robots.ints[DOWN][i] == FAILED


def is_sound(i: int, state: State) -> bool:
    """Whether nothing is wrong with robot i itself."""
    return state.robots.ints[MUTED][i] == 0 and state.robots.ints[DOWN][i] == WELL


def change_condition(i: int, kind: int, state: State) -> bool:
    """Changes what is wrong with robot i; False where that changes nothing."""
    ints = state.robots.ints
    down = ints[DOWN]
    if kind == FAIL:
        if down[i] == FAILED:
            return False
        fail(i, state)
    elif kind == STALL:
        if down[i] != WELL:
            return False
        down[i] = STALLED
    elif kind == MUTE:
        if ints[MUTED][i]:
            return False
        ints[MUTED][i] = 1
    elif kind == APART:
        if not has_radio(state) or state.radio.robots[SIDE][i]:
            return False
        state.radio.robots[SIDE][i] = 1
    else:
        return revive(i, state)
    return True


def fail(i: int, state: State) -> None:
    """Robot i fails for good."""
    floats = state.robots.floats
    state.robots.ints[DOWN][i] = FAILED
    floats[SAVED_TARGET][i] = floats[TARGET][i]
    floats[TARGET][i] = 0.0
    floats[TURN][i] = 0.0
    if state.robots.ints[ENDED][i] == 0:
        state.clock[LIVING] -= 1
    count_breakdowns(state)


def revive(i: int, state: State) -> bool:
    """Makes robot i well again; False where nothing is wrong with it, or it may not be."""
    floats = state.robots.floats
    ints = state.robots.ints
    is_apart = has_radio(state) and state.radio.robots[SIDE][i] != 0
    if (is_sound(i, state) and not is_apart) or not may_be_revived(i, state):
        return False
    if is_apart:
        state.radio.robots[SIDE][i] = 0
    had_failed = ints[DOWN][i] == FAILED
    ints[DOWN][i] = WELL
    if had_failed:
        end_breakdown(i, state)
        floats[TARGET][i] = floats[SAVED_TARGET][i]
        if ints[ENDED][i] == 0:
            state.clock[LIVING] += 1
    ints[MUTED][i] = 0
    ints[ASLEEP][i] = 0
    return True


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
