"""The step of a whole run, machines and world, for all robots at once: one source, run by CPython or compiled by Numba.

The order of a step: faults are injected, and failed robots towed; a team detects silent robots; sensors measure; every
machine whose tick is due receives the readings and reacts, in team order; devices execute the commands and move; a team
agrees at its points; robots move, and contacts are resolved; pens draw; shared variables spread. When nothing moves or
changes, deadlock detection runs.

Everything here and in what it calls is in the part of Python that Numba takes: loops over rows of numbers, whole
numbers that fit 64 bits, no division by zero, no function of the C library but the square root. So both give the same
numbers, bit by bit, and a run may pass from one to the other at any step. Rows are lists under CPython and arrays under
Numba. Nothing is allocated: the state has room for everything.
"""

from __future__ import annotations

from kitrobot.sim.physics.grids import fill
from kitrobot.sim.physics.step import move
from kitrobot.sim.step.actuation import busy, deliver_commands
from kitrobot.sim.step.deadlock_detection import (
    detect_deadlock,
    is_device_working,
    is_motion_unchanged,
    mark_activity,
    save_motion,
    should_compare_motion,
)
from kitrobot.sim.step.dispatch import AGREES, advance_all, sense_all
from kitrobot.sim.step.execution import react
from kitrobot.sim.step.failed_robots import clear_roads
from kitrobot.sim.step.fault_injection import inject_random_faults, inject_scheduled_faults
from kitrobot.sim.step.pens import draw
from kitrobot.sim.step.probes import PROBES_OFF, read_probes
from kitrobot.sim.step.sampling import sample, sample_done
from kitrobot.sim.step.substitution import detect_silent_robots, finish_team_step
from kitrobot.sim.tables.columns import (
    A_FRESH,
    A_KIND,
    DT,
    EVENT,
    EVENTS,
    FAILS,
    HEALTHY,
    LIVING,
    MOST_EVENTS,
    MOVED,
    OFF_ROADS,
    PLANNED,
    PLANS,
    PUSHABLES,
    REVIVALS,
    ROLLING,
    RUNNING,
    SEES,
    STUCK,
    TICK,
    WIDEST,
)
from kitrobot.sim.tables.state import State
from kitrobot.sim.tables.team_columns import TEAM_DUE, TEAM_LEASED, TEAM_OVER, TEAM_PENDING
from kitrobot.sim.team.radio import exchange_by_radio, has_radio
from kitrobot.sim.team.shared_variables import exchange


def advance(state: State, steps: int) -> int:
    """Runs up to so many steps and gives how many.

    It runs fewer when every program has ended, when all goals hold and only robots with faults go on, when
    nothing can change any more (STUCK), or when there is no room for what may happen in one more step, or for what is
    probed in it. What happens is written behind the EVENTS that are in `events` already.
    """
    clock = state.clock
    fixed = state.fixed
    fixed_floats = state.fixed_floats
    team = state.team.numbers
    has_team = len(state.team.set_first) > 0
    by_radio = has_radio(state)
    room = len(state.events) // EVENT - fixed[MOST_EVENTS]
    has_probes = len(state.probes.ints) > 0 and state.probes.count[0] != PROBES_OFF
    if has_probes:
        steps = min(steps, len(state.probes.ints) - state.probes.count[0])
    done = 0
    while done < steps and clock[EVENTS] <= room and can_continue(state) and not are_goals_reached(state):
        step = clock[TICK]
        events_before = clock[EVENTS]
        looks = should_compare_motion(step, state)
        if looks:
            save_motion(state)

        inject_faults(step, state)
        if has_team:
            detect_silent_robots(step, state)
        sample_sensors(step, state)
        ran = react(step, state)

        if len(state.actuators.late) > 0:
            deliver_commands(step, state)
        advance_all(fixed_floats[DT], state)
        if has_team:
            finish_team_step(state)
        move(state)
        if len(state.pens.actuators) > 0:
            draw(state)
        if by_radio:
            exchange_by_radio(step, state)
        elif len(state.shared.mine) > 0 and ran > 0:
            exchange(step, state)
        clock[TICK] = step + 1
        done += 1

        if clock[ROLLING] == 0 and clock[PUSHABLES] == 0:
            stirs = is_device_active(step, state)
        else:
            stirs = (
                clock[PUSHABLES] > 0 or not looks or is_device_working(step, state) or not is_motion_unchanged(state)
            )
        if stirs or clock[EVENTS] > events_before or clock[OFF_ROADS] > 0 or is_team_waiting(team):
            mark_activity(clock)
        elif clock[RUNNING] > 0:
            detect_deadlock(state)
        if has_probes:
            read_probes(state)
    return done


def inject_faults(step: int, state: State) -> None:
    """Applies the faults that are due in this step, and takes failed robots off their roads."""
    clock = state.clock
    if clock[PLANNED] < clock[PLANS]:
        inject_scheduled_faults(step, state)
    if state.fixed_floats[FAILS] > 0.0:
        inject_random_faults(step, state)
    if clock[OFF_ROADS] > 0:
        clear_roads(step, state)


def sample_sensors(step: int, state: State) -> None:
    """Samples the sensors, and puts the readings into the machines whose tick is due."""
    clock = state.clock
    if state.fixed[SEES] and clock[MOVED]:
        clock[MOVED] = 0
        fill(state.robots, state.fixed_floats[WIDEST], state.grid)
    sense_all(step, state)
    sample(step, state)
    if len(state.actuators.waited_for) > 0:
        sample_done(step, state)


def is_team_waiting(team: list[int]) -> bool:
    """Whether a team waits for a time to be over: that of a silent robot, of a unit of work that somebody has, or of
    messages on their way.
    """
    return team[TEAM_PENDING] > 0 or team[TEAM_LEASED] > 0 or team[TEAM_DUE] > 0


def can_continue(state: State) -> bool:
    """Whether the run has not come to its end: somebody goes on, or failed and is to be revived or towed, or the team
    does not know yet that it is to go on without somebody.
    """
    clock = state.clock
    team = state.team.numbers
    if clock[STUCK] > 0 or clock[RUNNING] == 0 or team[TEAM_OVER] > 0:
        return False
    return clock[LIVING] > 0 or clock[REVIVALS] > 0 or clock[OFF_ROADS] > 0 or team[TEAM_PENDING] > 0


def are_goals_reached(state: State) -> bool:
    """Whether every goal holds and nobody is left who could say so by ending its program: those whose programs have not
    ended failed, stalled or lost their radio, and none is to be revived. `goals` are the storehouses and their stock.
    """
    clock = state.clock
    goals = state.docks.goals
    if clock[HEALTHY] > 0 or clock[REVIVALS] > 0 or len(goals[0]) == 0:
        return False
    stock = state.docks.stock
    n = 0
    while n < len(goals[0]) and stock[goals[0][n]] == goals[1][n]:
        n += 1
    return n == len(goals[0])


def is_device_active(step: int, state: State) -> bool:
    """Whether a device received a new command in this step, or is active."""
    fresh = state.actuators.ints[A_FRESH]
    kinds = state.actuators.ints[A_KIND]
    count = len(fresh)
    k = 0
    while k < count and (fresh[k] != step + 1 or AGREES[kinds[k]]) and not busy(k, state):
        k += 1
    return k < count
