"""The motion of all robots on one road, as one number (a *conf*), and what can happen to them next.

A *conf* is a row of `confs`: the bodies of all robots on a road, and what follows from them. Numbers are assigned as
they come up. This module uses only the subset of Python that Numba compiles; -1 means that there is no room, or no
number left (`regs[CODE]` says of what): the caller makes room and calls again.
"""

from __future__ import annotations

from kitrobot.verifier.tables.bodies import after_fault, after_tick, gap_of, want_of, way_of, zone_of
from kitrobot.verifier.tables.columns import (
    A_BED,
    A_BEYOND,
    A_FOLLOWER,
    A_LATE,
    A_LEADER,
    A_SENSES,
    A_SENSES_AT,
    A_ZONE_AT,
    A_ZONES,
    AGENT,
    AGENTS,
    ALL_BITS,
    C_BACKWARD,
    C_BEGIN,
    C_FORWARD,
    C_MOVE,
    C_MOVE_SETS,
    C_MOVES,
    C_MUST,
    C_ROAD,
    C_STAND,
    CODE,
    CONF_WIDTH,
    CONFS,
    DOCKS,
    E_AGENT,
    E_OTHER,
    IS_WORKER,
    MISS_A,
    MISS_AS_WORKER,
    MOVE,
    MOVES,
    MULTIPLIER,
    PLACES,
    ROAD_FIELD,
    ROOM_CONFS,
    ROOM_MOVES,
    S_VIEW,
    WIDEN,
)
from kitrobot.verifier.tables.motion import BEGIN, WAYS_TO_MOVE, ZONE, ZONE_NUMBERS, move, next_zone
from kitrobot.verifier.tables.roads import PRESSED
from kitrobot.verifier.tables.tables import Row, Tables


def intern_conf(t: Tables, road: int) -> int:
    """The number of the bodies in `made` on a road."""
    regs, fixed, confs, made, slots = t.regs, t.fixed, t.confs, t.made, t.conf_slots
    places, width, docks = fixed[PLACES], fixed[CONF_WIDTH], fixed[DOCKS]
    bodies = C_STAND + docks + places
    last = len(slots) - 1
    at = bodies_hash(made, 0, places, road) & last
    while slots[at] != 0:
        row = (slots[at] - 1) * width
        k = 0 if confs[row + C_ROAD] == road else places + 1
        while k < places and confs[row + bodies + k] == made[k]:
            k += 1
        if k == places:
            return slots[at] - 1
        at = at + 1 & last
    if regs[IS_WORKER]:
        regs[CODE] = MISS_AS_WORKER
        return -1
    number = regs[CONFS]
    if (number + 1) * width > len(confs) or 2 * number >= len(slots):
        regs[CODE] = ROOM_CONFS
        return -1
    if number > t.mask[fixed[ROAD_FIELD] + road]:
        regs[CODE] = WIDEN
        regs[MISS_A] = fixed[ROAD_FIELD] + road
        return -1
    row = number * width
    confs[row + C_ROAD] = road
    confs[row + C_MOVES] = -1
    confs[row + C_MOVE_SETS] = -1
    confs[row + C_MUST] = 0
    confs[row + C_BEGIN] = 0
    for k in range(places):
        confs[row + bodies + k] = made[k]
    for k in range(8 * places):
        confs[row + bodies + places + k] = -1
    fill_views(t, row, road)
    slots[at] = number + 1
    regs[CONFS] = number + 1
    return number


def bodies_hash(table: Row, first: int, places: int, road: int) -> int:
    """Where to look for the bodies that begin at a place of a table."""
    h = road + 1
    for k in range(first, first + places):
        h = (h ^ table[k]) * MULTIPLIER & ALL_BITS
        h ^= h >> 29
    return h


def fill_conf_slots(t: Tables) -> None:
    """Rebuilds the slots of confs."""
    fixed, confs, slots = t.fixed, t.confs, t.conf_slots
    last = len(slots) - 1
    for at in range(last + 1):
        slots[at] = 0
    for number in range(t.regs[CONFS]):
        row = number * fixed[CONF_WIDTH]
        bodies = row + C_STAND + fixed[DOCKS] + fixed[PLACES]
        at = bodies_hash(confs, bodies, fixed[PLACES], confs[row + C_ROAD]) & last
        while slots[at] != 0:
            at = at + 1 & last
        slots[at] = number + 1


def fill_views(t: Tables, row: int, road: int) -> None:
    """Fills the derived columns of a conf: moving robots, robots in each dock, and what each robot senses."""
    fixed, confs, agents, geo = t.fixed, t.confs, t.agents, t.geo
    places, docks = fixed[PLACES], fixed[DOCKS]
    views, bodies = row + C_STAND + docks, row + C_STAND + docks + places
    forward = backward = 0
    for d in range(docks):
        confs[row + C_STAND + d] = 0
    for k in range(places):
        i = t.road_agents[road * places + k]
        confs[views + k] = 0
        if i < 0:
            continue
        a = i * AGENT
        me = confs[bodies + k]
        way, zone = way_of(me), zone_of(me)
        if way != 0 and gap_of(me) != PRESSED and agents[a + A_ZONES] > 1 and next_zone(agents, i, zone, way) >= 0:
            if way > 0:
                forward |= 1 << i
            else:
                backward |= 1 << i
        at = agents[a + A_ZONE_AT] + zone * (ZONE_NUMBERS + docks)
        if way == 0 and agents[a + A_BED]:
            for d in range(docks):
                if geo[at + ZONE_NUMBERS + d]:
                    confs[row + C_STAND + d] |= 1 << i
        confs[views + k] = view_of(t, bodies, i, k, geo[at + 2]) << S_VIEW
    confs[row + C_FORWARD] = forward
    confs[row + C_BACKWARD] = backward


def view_of(t: Tables, bodies: int, i: int, k: int, zone_class: int) -> int:
    """What agent i senses of its road: the class of its zone, and a bit for each collision sensor."""
    agents, geo, confs = t.agents, t.geo, t.confs
    a = i * AGENT
    me = confs[bodies + k]
    ahead, gap = agents[a + A_LEADER] >= 0, gap_of(me)
    at, own, theirs = agents[a + A_SENSES_AT], agents[a + A_BEYOND] + 2, 0
    behind = agents[a + A_FOLLOWER]
    if behind >= 0:
        follower = t.road_agents[
            confs[bodies - t.fixed[PLACES] - t.fixed[DOCKS] - C_STAND + C_ROAD] * t.fixed[PLACES] + behind
        ]
        theirs = agents[follower * AGENT + A_BEYOND] + 2
    looks_back = way_of(me) < 0 or (way_of(me) == 0 and want_of(me) < 0)
    found = zone_class
    for _ in range(agents[a + A_SENSES]):
        bit = 0
        if looks_back:
            if behind >= 0:
                bit = geo[at + own + gap_of(confs[bodies + behind])]
        elif ahead:
            bit = geo[at + gap]
        found = found << 1 | bit
        at += own + theirs
    return found


def conf_after_tick(t: Tables, conf: int, k: int, command: int) -> int:
    """The conf after a tick of the robot at place k.

    `command` is twice its direction + 2, plus 1 if it has more ticks.
    """
    fixed, confs = t.fixed, t.confs
    places = fixed[PLACES]
    row = conf * fixed[CONF_WIDTH]
    bodies = row + C_STAND + fixed[DOCKS] + places
    at = bodies + places + 8 * k + command
    if confs[at] < 0:
        for other in range(places):
            t.made[other] = confs[bodies + other]
        t.made[k] = after_tick(confs[bodies + k], (command >> 1) - 2, command & 1 == 1)
        confs[at] = intern_conf(t, confs[row + C_ROAD])
    return confs[at]


def conf_after_fault(t: Tables, conf: int, k: int, down: int) -> int:
    """The conf after the robot at place k failed, stalled or runs again."""
    fixed, confs = t.fixed, t.confs
    row = conf * fixed[CONF_WIDTH]
    bodies = row + C_STAND + fixed[DOCKS] + fixed[PLACES]
    for other in range(fixed[PLACES]):
        t.made[other] = confs[bodies + other]
    t.made[k] = after_fault(confs[bodies + k], down)
    return intern_conf(t, confs[row + C_ROAD])


def fill_moves(t: Tables, conf: int) -> int:
    """Finds what robots on a road can do next; how many moves, which are behind one another in `moves`."""
    regs, fixed, confs, agents, moves = t.regs, t.fixed, t.confs, t.agents, t.moves
    places = fixed[PLACES]
    row = conf * fixed[CONF_WIDTH]
    road = confs[row + C_ROAD]
    bodies = row + C_STAND + fixed[DOCKS] + places
    if regs[IS_WORKER]:
        regs[CODE] = MISS_AS_WORKER
        return -1
    first = regs[MOVES]
    if (first + places * WAYS_TO_MOVE) * MOVE > len(moves):
        regs[CODE] = ROOM_MOVES
        return -1
    count = begin = must = 0
    for k in range(places):
        i = t.road_agents[road * places + k]
        if i < 0:
            continue
        behind = agents[i * AGENT + A_FOLLOWER]
        ahead = agents[i * AGENT + A_LEADER]
        for which in range(WAYS_TO_MOVE):
            for other in range(places):
                t.made[other] = confs[bodies + other]
            what = move(t, bodies, k, i, which, t.road_agents[road * places + behind] if behind >= 0 else -1)
            if what == 0:
                continue
            to = intern_conf(t, road)
            if to < 0:
                return -1
            at = (first + count) * MOVE
            moves[at] = to
            moves[at + 1] = what | i << E_AGENT
            if ahead >= 0:
                moves[at + 1] |= t.road_agents[road * places + ahead] + 1 << E_OTHER
            moves[at + 2] = 0
            if what == BEGIN:
                moves[at + 2] = 1 + fixed[AGENTS] + i
                if not is_last(t, bodies, k, i):
                    begin |= 1 << i
                    if not agents[i * AGENT + A_LATE] and not is_pressing(t, bodies, k, i):
                        must = 1
            elif what == ZONE:
                moves[at + 2] = 1 + 3 * fixed[AGENTS] + i
            count += 1
    confs[row + C_MOVE] = first
    confs[row + C_BEGIN] = begin
    confs[row + C_MUST] = must
    confs[row + C_MOVES] = count
    regs[MOVES] = first + count
    return count


def is_last(t: Tables, bodies: int, k: int, i: int) -> bool:
    """Whether a robot is in the last zone in the direction of its command: it may be at the road's end,
    where it stands for ever.
    """
    me = t.confs[bodies + k]
    return next_zone(t.agents, i, zone_of(me), want_of(me)) < 0


def is_pressing(t: Tables, bodies: int, k: int, i: int) -> bool:
    """Whether a robot presses on the one before it, in the direction of its command."""
    me = t.confs[bodies + k]
    if want_of(me) > 0:
        return gap_of(me) == PRESSED
    behind = t.agents[i * AGENT + A_FOLLOWER]
    return behind >= 0 and gap_of(t.confs[bodies + behind]) == PRESSED
