"""The sets of moves that the robots of a road can make between two ticks of lockstep, each move once per robot.

This module uses only the subset of Python that Numba compiles; -1 means the same as in `traffic`.
"""

from __future__ import annotations

from kitrobot.verifier.tables.bodies import gap_of
from kitrobot.verifier.tables.columns import (
    ALL_BITS,
    C_MOVE,
    C_MOVE_SET,
    C_MOVE_SETS,
    C_MOVES,
    C_MUST,
    C_ROAD,
    C_STAND,
    CODE,
    CONF_WIDTH,
    DOCKS,
    E_AGENT,
    E_KIND,
    E_MASK,
    IS_WORKER,
    LOG,
    MISS_AS_WORKER,
    MOVE,
    MOVE_SET,
    MOVE_SETS,
    MULTIPLIER,
    PLACES,
    POOL_WIDTH,
    ROOM_LOG,
    ROOM_MOVE_SETS,
    TOO_MANY,
    USED_BITS,
)
from kitrobot.verifier.tables.events import MOST_AT_ONCE
from kitrobot.verifier.tables.motion import BEGIN, HALT, WIDER, ZONE
from kitrobot.verifier.tables.tables import Tables
from kitrobot.verifier.tables.traffic import fill_moves

P_CONF, P_PARENT, P_EVENT, P_SLOT, P_GIVEN = range(5)
P_USED = 5
"""A row of `pool`: a number, the row it comes from, the event between; its place in `pool_slots`, and in `given_slots`
(-1: none); then what robots did of what they do once, as bits.
"""
USED_PER_WORD = 60


def fill_move_sets(t: Tables, conf: int) -> int:
    """Finds what may happen on a road before all tick again; how many ways, behind one another in `move_sets`.

    A robot begins to roll, or halts, once, comes into another zone once, and to each class of gap once from either
    side. No robot waits that can begin to roll.
    """
    regs, fixed, pool = t.regs, t.fixed, t.pool
    if regs[IS_WORKER]:
        regs[CODE] = MISS_AS_WORKER
        return -1
    width, conf_width = fixed[POOL_WIDTH], fixed[CONF_WIDTH]
    first, first_log = regs[MOVE_SETS], regs[LOG]
    for k in range(width):
        pool[k] = 0
    pool[P_CONF], pool[P_PARENT], pool[P_GIVEN] = conf, -1, -1
    pool[P_SLOT] = pool_slot(t, 0, False)
    t.pool_slots[pool[P_SLOT]] = 1
    count, at, code = 1, 0, 0
    while at < count and code == 0:
        row = at * width
        now = pool[row + P_CONF]
        moves = t.confs[now * conf_width + C_MOVES]
        if moves < 0:
            moves = fill_moves(t, now)
            if moves < 0:
                code = regs[CODE]
                break
        if t.confs[now * conf_width + C_MUST] == 0:
            slot = pool_slot(t, at, True)
            if t.given_slots[slot] == 0:
                t.given_slots[slot] = at + 1
                pool[row + P_GIVEN] = slot
                code = write_move_set(t, at)
        count = add_moves(t, at, moves, count)
        if count > MOST_AT_ONCE:
            code = TOO_MANY
        at += 1
    for k in range(count):
        t.pool_slots[pool[k * width + P_SLOT]] = 0
        if pool[k * width + P_GIVEN] >= 0:
            t.given_slots[pool[k * width + P_GIVEN]] = 0
    if code != 0:
        regs[CODE] = code
        regs[MOVE_SETS], regs[LOG] = first, first_log
        return -1
    t.confs[conf * conf_width + C_MOVE_SET] = first
    t.confs[conf * conf_width + C_MOVE_SETS] = regs[MOVE_SETS] - first
    return regs[MOVE_SETS] - first


def add_moves(t: Tables, at: int, moves: int, count: int) -> int:
    """Adds a row to the pool for each move after row `at` that is new; returns how many rows there are then."""
    pool, width = t.pool, t.fixed[POOL_WIDTH]
    row = at * width
    first = t.confs[pool[row + P_CONF] * t.fixed[CONF_WIDTH] + C_MOVE]
    m = first
    while m < first + moves and count <= MOST_AT_ONCE:
        after, event = t.moves[m * MOVE], t.moves[m * MOVE + 1]
        m += 1
        bit = own_bit(t, after, event)
        if pool[row + P_USED + bit // USED_PER_WORD] >> bit % USED_PER_WORD & 1:
            continue
        new = count * width
        for k in range(P_USED, width):
            pool[new + k] = pool[row + k]
        pool[new + P_USED + bit // USED_PER_WORD] |= 1 << bit % USED_PER_WORD
        pool[new + P_CONF], pool[new + P_PARENT], pool[new + P_EVENT], pool[new + P_GIVEN] = after, at, event, -1
        slot = pool_slot(t, count, False)
        if t.pool_slots[slot] == 0:
            pool[new + P_SLOT] = slot
            t.pool_slots[slot] = count + 1
            count += 1
    return count


def own_bit(t: Tables, after: int, event: int) -> int:
    """Which of the things that robots do once a move is."""
    fixed = t.fixed
    i = event >> E_AGENT & E_MASK
    row = after * fixed[CONF_WIDTH]
    road, what = t.confs[row + C_ROAD], event & E_KIND
    k = 0
    while t.road_agents[road * fixed[PLACES] + k] != i:
        k += 1
    base = k * fixed[USED_BITS]
    if what <= HALT:
        return base
    if what == ZONE:
        return base + 1
    gap = gap_of(t.confs[row + C_STAND + fixed[DOCKS] + fixed[PLACES] + k])
    return base + 2 + 2 * gap + (1 if what == WIDER else 0)


def once_only(t: Tables, row: int, word: int) -> int:
    """Of a word of bits those that say who began or halted, and who came into another zone."""
    bits = t.fixed[USED_BITS]
    found = 0
    for k in range(t.fixed[PLACES]):
        for bit in range(k * bits, k * bits + 2):
            if bit // USED_PER_WORD == word:
                found |= t.pool[row + P_USED + word] & 1 << bit % USED_PER_WORD
    return found


def pool_slot(t: Tables, number: int, is_given: bool) -> int:
    """Where a row of the pool is found, or is to be put; of those that were given only who began or moved counts."""
    pool, width = t.pool, t.fixed[POOL_WIDTH]
    slots = t.given_slots if is_given else t.pool_slots
    row = number * width
    h = pool[row + P_CONF] * MULTIPLIER & ALL_BITS
    for k in range(width - P_USED):
        word = once_only(t, row, k) if is_given else pool[row + P_USED + k]
        h = ((h ^ h >> 31) + word) * MULTIPLIER & ALL_BITS
    last = len(slots) - 1
    at = h >> 31 & last
    while slots[at] != 0:
        other = (slots[at] - 1) * width
        same = pool[other + P_CONF] == pool[row + P_CONF]
        for k in range(width - P_USED):
            if is_given:
                same = same and once_only(t, other, k) == once_only(t, row, k)
            else:
                same = same and pool[other + P_USED + k] == pool[row + P_USED + k]
        if same:
            return at
        at = at + 1 & last
    return at


def write_move_set(t: Tables, number: int) -> int:
    """Writes a row of the pool behind the moments, and its events into the log; 0, or why there is no room."""
    regs, pool, width = t.regs, t.pool, t.fixed[POOL_WIDTH]
    events = 0
    at = number
    while pool[at * width + P_PARENT] >= 0:
        events += 1
        at = pool[at * width + P_PARENT]
    to, log = regs[MOVE_SETS] * MOVE_SET, regs[LOG]
    if to + MOVE_SET > len(t.move_sets):
        return ROOM_MOVE_SETS
    if log + events > len(t.log):
        return ROOM_LOG
    begins = zones = kinds = 0
    at, left = number, events
    while left > 0:
        left -= 1
        event = pool[at * width + P_EVENT]
        t.log[log + left] = event
        kinds |= 1 << (event & E_KIND)
        if event & E_KIND == BEGIN:
            begins |= 1 << (event >> E_AGENT & E_MASK)
        elif event & E_KIND == ZONE:
            zones |= 1 << (event >> E_AGENT & E_MASK)
        at = pool[at * width + P_PARENT]
    t.move_sets[to], t.move_sets[to + 1], t.move_sets[to + 2] = pool[number * width + P_CONF], begins, zones
    t.move_sets[to + 3], t.move_sets[to + 4], t.move_sets[to + 5] = kinds, log, events
    regs[MOVE_SETS] += 1
    regs[LOG] += events
    return 0
