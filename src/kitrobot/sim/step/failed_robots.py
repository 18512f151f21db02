"""What becomes of robots that failed on a road, in a step, by the mission's rule; and of those that their team misses,
because they stalled or lost their radio: for the others they are gone, and in the way.

They *stay* in everybody's way; or they are *towed* off so many steps after they failed, with a box on them put back
into the storehouse it came from; or the others *pass* them from the moment they stand. Who stalled may be driving on:
it is towed as it is. A robot that is off its road r
has the road -2 - r: nobody touches it, no arm reaches it, no sensor notices it. One that was towed stands beside the
world and is there for good: reviving it changes nothing. One that is passed stays where it is, with its box, and is on
its road again when it is revived.

A box is lost when there is no room for it where it came from; then the ORIGIN of its robot is -1.
"""

from __future__ import annotations

from kitrobot.sim.physics.contacts import measure_gaps, sort_along
from kitrobot.sim.step.deadlock_detection import mark_activity
from kitrobot.sim.tables.columns import (
    CONTACTS,
    DOWN,
    FAILED,
    FREE,
    LOAD,
    MOVED,
    OFF_ROADS,
    ORIGIN,
    RADIUS,
    ROAD,
    RULE,
    SINCE,
    SPEED,
    STALLED,
    TARGET,
    TOUCHING,
    TOW_AFTER,
    TOWED,
    TURN,
    X,
    Y,
    record_event,
)
from kitrobot.sim.tables.state import Robots, State
from kitrobot.sim.tables.team_columns import T_MISSED, T_SILENT

STAY, TOW, PASS = range(3)
"""The order of `BreakdownRule`."""

NO_BOX, BOX_BACK, BOX_LOST, PASSED = range(4)
"""What is told besides of a robot that is off its road."""


def may_be_revived(i: int, state: State) -> bool:
    """Whether robot i was not towed."""
    return not is_towed(i, state)


def is_broken_down(i: int, state: State) -> bool:
    """Whether robot i failed, or is missed by its team."""
    missed = state.team.robots[T_MISSED]
    return state.robots.ints[DOWN][i] == FAILED or (len(missed) > 0 and missed[i] != 0)


def is_towed(i: int, state: State) -> bool:
    """Whether robot i stands beside the world, for good."""
    return state.robots.ints[ROAD][i] < FREE and state.fixed[RULE] == TOW


def count_breakdowns(state: State) -> None:
    """Who broke down on a road, or did so no more, just now: whoever did is to be taken off it."""
    road = state.robots.ints[ROAD]
    count = 0
    if state.fixed[RULE] != STAY:
        for i in range(len(road)):
            if road[i] >= 0 and is_broken_down(i, state):
                count += 1
    state.clock[OFF_ROADS] = count


def end_breakdown(i: int, state: State) -> None:
    """Robot i, which had failed or was missed, is back just now: on its road, unless it was towed."""
    road = state.robots.ints[ROAD]
    if road[i] < FREE and state.fixed[RULE] == PASS and not is_broken_down(i, state):
        road[i] = -2 - road[i]
        rearrange(state)
    count_breakdowns(state)


def clear_roads(step: int, state: State) -> None:
    """Takes those that failed off their roads, when they stand and it is time."""
    ints = state.robots.ints
    down = ints[DOWN]
    road = ints[ROAD]
    since = ints[SINCE]
    speed = state.robots.floats[SPEED]
    after = state.fixed[TOW_AFTER]
    cleared = 0
    for i in range(len(down)):
        if road[i] < 0 or not is_broken_down(i, state):
            continue
        begun = since[i] if down[i] == FAILED else state.team.robots[T_SILENT][i]
        stands = speed[i] == 0.0 or (down[i] == STALLED and state.fixed[RULE] == TOW)
        if stands and step - begun >= after:
            road[i] = -2 - road[i]
            forget_contacts(i, state)
            cleared += 1
            if state.fixed[RULE] == TOW:
                tow(i, state)
            else:
                record_event(state.events, state.clock, TOWED, i, -1, PASSED)
    if cleared > 0:
        count_breakdowns(state)
        rearrange(state)
        mark_activity(state.clock)


def tow(i: int, state: State) -> None:
    """Puts robot i beside the world, and its box back where it came from."""
    ints = state.robots.ints
    floats = state.robots.floats
    stock = state.docks.stock
    before = 0
    for k in range(len(ints[ROAD])):
        if ints[ROAD][k] < FREE and k != i:
            before += 1
    radius = floats[RADIUS][i]
    floats[X][i] = (2.0 * before + 1.0) * 1.1 * radius
    floats[Y][i] = -1.5 * radius
    floats[SPEED][i] = 0.0
    floats[TARGET][i] = 0.0
    floats[TURN][i] = 0.0
    house = ints[ORIGIN][i] - 1
    much = NO_BOX
    if ints[LOAD][i]:
        ints[LOAD][i] = 0
        if house >= 0 and stock[house] < state.docks.capacity[house]:
            stock[house] += 1
            much = BOX_BACK
        else:
            ints[ORIGIN][i] = -1
            much = BOX_LOST
    record_event(state.events, state.clock, TOWED, i, house, much)


def rearrange(state: State) -> None:
    """Who is ahead of whom, after somebody left a road or came back."""
    robots: Robots = state.robots
    sort_along(robots)
    measure_gaps(robots, state.roads)
    state.clock[MOVED] = 1


def forget_contacts(i: int, state: State) -> None:
    """Robot i touches nobody any more."""
    clock = state.clock
    before = state.contacts.before
    touching = state.robots.ints[TOUCHING]
    count = clock[CONTACTS]
    for k in range(2 * count):
        if before[k] >= 0:
            touching[before[k]] = 0
    kept = 0
    for k in range(count):
        one = before[2 * k]
        other = before[2 * k + 1]
        if one == i or other == i:
            continue
        before[2 * kept] = one
        before[2 * kept + 1] = other
        kept += 1
        if one >= 0:
            touching[one] = 1
        if other >= 0:
            touching[other] = 1
    clock[CONTACTS] = kept
