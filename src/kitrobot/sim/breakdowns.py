"""What becomes of robots that failed on a road, in a step, by the mission's rule.

They *stay* in everybody's way; or they are *towed* off so many steps after they failed, with a box on them put back
into the storehouse it came from; or the others *pass* them from the moment they stand. A robot that is off its road r
has the road -2 - r: nobody touches it, no arm reaches it, no sensor notices it. One that was towed stands beside the
world and is there for good: reviving it changes nothing. One that is passed stays where it is, with its box, and is on
its road again when it is revived.

A box is lost when there is no room for it where it came from; then the ORIGIN of its robot is -1.
"""

from __future__ import annotations

from kitrobot.sim.columns import (
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
    TOUCHING,
    TOW_AFTER,
    TOWED,
    X,
    Y,
    tell,
)
from kitrobot.sim.contacts import measure_gaps, sort_along
from kitrobot.sim.deadlock_detection import stirred
from kitrobot.sim.state import Robots, State

STAY, TOW, PASS = range(3)
"""The order of `BreakdownRule`."""

NO_BOX, BOX_BACK, BOX_LOST, PASSED = range(4)
"""What is told besides of a robot that is off its road."""


def may_be_revived(i: int, state: State) -> bool:
    """Whether robot i was not towed."""
    return state.robots.ints[ROAD][i] >= FREE or state.fixed[RULE] != TOW


def begin_breakdown(i: int, state: State) -> None:
    """Robot i has failed just now: if it is on a road, it is to be taken off that."""
    if state.fixed[RULE] != STAY and state.robots.ints[ROAD][i] >= 0:
        state.clock[OFF_ROADS] += 1


def end_breakdown(i: int, state: State) -> None:
    """Robot i, which had failed, is revived just now."""
    road = state.robots.ints[ROAD]
    if state.fixed[RULE] == STAY or road[i] == FREE:
        return
    if road[i] >= 0:
        state.clock[OFF_ROADS] -= 1
        return
    road[i] = -2 - road[i]
    rearrange(state)


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
        if down[i] == FAILED and road[i] >= 0 and speed[i] == 0.0 and step - since[i] >= after:
            road[i] = -2 - road[i]
            forget_contacts(i, state)
            state.clock[OFF_ROADS] -= 1
            cleared += 1
            if state.fixed[RULE] == TOW:
                tow(i, state)
            else:
                tell(state.events, state.clock, TOWED, i, -1, PASSED)
    if cleared > 0:
        rearrange(state)
        stirred(state.clock)


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
    tell(state.events, state.clock, TOWED, i, house, much)


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
