"""The step of a whole run, machines and world, for all robots at once: one source, run by CPython or compiled by Numba.

In this order: robots fail, are revived or towed, and a team finds out whom it misses; sensors measure; every machine
whose tick it is is given what they read, then all of these react, in team order; devices take the commands and move; a
team agrees at its points; robots move, and what touches is parted; pens draw; shared variables spread; and when
nothing stirs, it is asked whether anything ever will.

Everything here and in what it calls is in the part of Python that Numba takes: loops over rows of numbers, whole
numbers that fit 64 bits, no division by zero, no function of the C library but the square root. So both give the same
numbers, bit by bit, and a run may pass from one to the other at any step. Rows are lists under CPython and arrays under
Numba. Nothing is allocated: the state has room for everything.
"""

from __future__ import annotations

from kitrobot.sim.actuation import busy, deliver
from kitrobot.sim.breakdowns import clear_roads
from kitrobot.sim.columns import (
    A_FRESH,
    A_KIND,
    DT,
    EVENT,
    EVENTS,
    FAILS,
    LIVING,
    MOST_EVENTS,
    MOVED,
    OFF_ROADS,
    PLANNED,
    PLANS,
    REVIVALS,
    ROLLING,
    RUNNING,
    SEES,
    SOUND,
    STUCK,
    THINGS,
    TICK,
    WIDEST,
)
from kitrobot.sim.deadlock_detection import (
    detect_deadlock,
    is_at_work,
    is_held,
    may_be_held,
    remember,
    stirred,
)
from kitrobot.sim.dispatch import AGREES, advance_all, sense_all
from kitrobot.sim.execution import react
from kitrobot.sim.faults import harm_by_chance, harm_on_schedule
from kitrobot.sim.grids import fill
from kitrobot.sim.pens import draw
from kitrobot.sim.physics import move
from kitrobot.sim.radio import exchange_by_radio, has_radio
from kitrobot.sim.sampling import sample, sample_done
from kitrobot.sim.shared_variables import exchange
from kitrobot.sim.state import State
from kitrobot.sim.substitution import look_for_silent, settle
from kitrobot.sim.team_columns import TEAM_DUE, TEAM_LEASED, TEAM_OVER, TEAM_PENDING


def advance(state: State, steps: int) -> int:
    """Runs up to so many steps and gives how many.

    It runs fewer when every program has ended, when all goals hold and only robots that something befell go on, when
    nothing can change any more (STUCK), or when there is no room for what may happen in one more step. What happens is
    written behind the EVENTS that are in `events` already.
    """
    clock = state.clock
    fixed = state.fixed
    fixed_floats = state.fixed_floats
    team = state.team.numbers
    has_team = len(state.team.set_first) > 0
    by_radio = has_radio(state)
    room = len(state.events) // EVENT - fixed[MOST_EVENTS]
    done = 0
    while done < steps and clock[EVENTS] <= room and is_going_on(state) and not is_reached(state):
        step = clock[TICK]
        events_before = clock[EVENTS]
        looks = may_be_held(step, state)
        if looks:
            remember(state)

        befall(step, state)
        if has_team:
            look_for_silent(step, state)
        measure(step, state)
        ran = react(step, state)

        if len(state.actuators.late) > 0:
            deliver(step, state)
        advance_all(fixed_floats[DT], state)
        if has_team:
            settle(state)
        move(state)
        if len(state.pens.actuators) > 0:
            draw(state)
        if by_radio:
            exchange_by_radio(step, state)
        elif len(state.shared.mine) > 0 and ran > 0:
            exchange(step, state)
        clock[TICK] = step + 1
        done += 1

        if clock[ROLLING] == 0 and clock[THINGS] == 0:
            stirs = is_stirring(step, state)
        else:
            stirs = clock[THINGS] > 0 or not looks or is_at_work(step, state) or not is_held(state)
        if stirs or clock[EVENTS] > events_before or clock[OFF_ROADS] > 0 or is_waited_for(team):
            stirred(clock)
        elif clock[RUNNING] > 0:
            detect_deadlock(state)
    return done


def befall(step: int, state: State) -> None:
    """The beginning of a step: what befalls robots, and those that are taken off their roads."""
    clock = state.clock
    if clock[PLANNED] < clock[PLANS]:
        harm_on_schedule(step, state)
    if state.fixed_floats[FAILS] > 0.0:
        harm_by_chance(step, state)
    if clock[OFF_ROADS] > 0:
        clear_roads(step, state)


def measure(step: int, state: State) -> None:
    """What sensors read in a step, given to the machines whose tick it is."""
    clock = state.clock
    if state.fixed[SEES] and clock[MOVED]:
        clock[MOVED] = 0
        fill(state.robots, state.fixed_floats[WIDEST], state.grid)
    sense_all(step, state)
    sample(step, state)
    if len(state.actuators.waited_for) > 0:
        sample_done(step, state)


def is_waited_for(team: list[int]) -> bool:
    """Whether a team waits for a time to be over: that of a silent robot, of a unit of work that somebody has, or of
    messages on their way.
    """
    return team[TEAM_PENDING] > 0 or team[TEAM_LEASED] > 0 or team[TEAM_DUE] > 0


def is_going_on(state: State) -> bool:
    """Whether the run has not come to its end: somebody goes on, or failed and is to be revived or towed, or the team
    does not know yet that it is to go on without somebody.
    """
    clock = state.clock
    team = state.team.numbers
    if clock[STUCK] > 0 or clock[RUNNING] == 0 or team[TEAM_OVER] > 0:
        return False
    return clock[LIVING] > 0 or clock[REVIVALS] > 0 or clock[OFF_ROADS] > 0 or team[TEAM_PENDING] > 0


def is_reached(state: State) -> bool:
    """Whether every goal holds and nobody is left who could say so by ending its program: those whose programs have not
    ended failed, stalled or lost their radio, and none is to be revived. `goals` are the storehouses and their stock.
    """
    clock = state.clock
    goals = state.docks.goals
    if clock[SOUND] > 0 or clock[REVIVALS] > 0 or len(goals[0]) == 0:
        return False
    stock = state.docks.stock
    n = 0
    while n < len(goals[0]) and stock[goals[0][n]] == goals[1][n]:
        n += 1
    return n == len(goals[0])


def is_stirring(step: int, state: State) -> bool:
    """Whether a device was told something new in this step, or has something to do."""
    fresh = state.actuators.ints[A_FRESH]
    kinds = state.actuators.ints[A_KIND]
    count = len(fresh)
    k = 0
    while k < count and (fresh[k] != step + 1 or AGREES[kinds[k]]) and not busy(k, state):
        k += 1
    return k < count
