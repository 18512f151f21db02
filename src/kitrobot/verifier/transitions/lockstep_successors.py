"""The successors of a state in *lockstep*: actions complete, robots move, faults occur, and all agents tick at once.

This module uses only the subset of Python that Numba compiles; -1 means the same as in `interleaved_successors`.
"""

from __future__ import annotations

from kitrobot.verifier.tables.columns import (
    AFTER,
    AGENTS,
    ALL_BITS,
    C_MOVE_SET,
    C_MOVE_SETS,
    CODE,
    CONF_WIDTH,
    E_AGENT,
    E_KIND,
    E_MASK,
    FOUND,
    I_ENDS,
    INSIDE_STRIDE,
    INSIDE_WIDTH,
    IS_WORKER,
    LINE,
    MISS_AS_WORKER,
    MOVE_SET,
    MULTIPLIER,
    NEXTS,
    OTHER_MULTIPLIER,
    ROAD_FIELD,
    ROADS,
    ROOM_NEXT,
    SEEK,
    TAKEN,
    TAKEN_WIDTH,
    TOO_MANY,
)
from kitrobot.verifier.tables.state_decoding import decode
from kitrobot.verifier.tables.tables import Tables
from kitrobot.verifier.transitions.absence_detection import is_team_over
from kitrobot.verifier.transitions.lockstep_ticks import MOST_TRIED, find_ticks
from kitrobot.verifier.transitions.move_sets import fill_move_sets
from kitrobot.verifier.transitions.world_transitions import write_completions


def expand_lockstep(t: Tables, x: int, y: int) -> int:
    """Finds the steps out of a state; steps to the same state with the same progress are stored once."""
    regs, fixed, line = t.regs, t.fixed, t.line
    for n in range(regs[NEXTS]):
        t.next_slots[t.next_event[n]] = 0
    regs[NEXTS] = 0
    regs[FOUND] = -1
    line[0], line[1], line[2], line[3], line[4], line[5] = x, y, 0, -1, 0, 0
    count, at, tried = 1, 0, 0
    while at < count:
        decode(t, line[at * LINE], line[at * LINE + 1])
        if at == 0 and is_team_over(t):
            return 0
        last = -1 if at == 0 else line[at * LINE + 2] >> E_AGENT & E_MASK
        for i in range(last + 1, fixed[AGENTS]):
            row = (i * fixed[INSIDE_STRIDE] + t.now[1 + i]) * fixed[INSIDE_WIDTH]
            if not t.insides[row + I_ENDS]:
                continue
            found = write_completions(t, line[at * LINE], line[at * LINE + 1], i, count)
            if found < 0:
                return -1
            for n in range(count, count + found):
                line[n * LINE + 3] = at
                line[n * LINE + 4] = line[at * LINE + 4] | 1 << (line[n * LINE + 2] & E_KIND)
                line[n * LINE + 5] = line[at * LINE + 5] | 1 << i
            count += found
        tried = combine_moves(t, at, tried)
        if tried < 0:
            return -1
        at += 1
    return regs[NEXTS]


def combine_moves(t: Tables, ended: int, tried: int) -> int:
    """Adds, after the completions of a row of `line`, every combination of moves on all roads, and then all ticks.

    Behind the reactions of the agents and their choices, `seen` has the chosen move set of each road.
    """
    fixed, seen = t.fixed, t.seen
    roads, n = fixed[ROADS], fixed[AGENTS]
    chosen = 3 * n
    was_x, was_y = t.line[ended * LINE], t.line[ended * LINE + 1]
    for road in range(roads):
        f = fixed[ROAD_FIELD] + road
        conf = (was_y if t.word[f] else was_x) >> t.shift[f] & t.mask[f]
        if t.confs[conf * fixed[CONF_WIDTH] + C_MOVE_SETS] < 0 and fill_move_sets(t, conf) < 0:
            return -1
        if t.confs[conf * fixed[CONF_WIDTH] + C_MOVE_SETS] == 0:
            return tried
        seen[chosen + road] = 0
    while True:
        x, y = was_x, was_y
        kinds, begins, zones = t.line[ended * LINE + 4], 0, 0
        for road in range(roads):
            f = fixed[ROAD_FIELD] + road
            conf = (was_y if t.word[f] else was_x) >> t.shift[f] & t.mask[f]
            m = (t.confs[conf * fixed[CONF_WIDTH] + C_MOVE_SET] + seen[chosen + road]) * MOVE_SET
            d = (conf ^ t.move_sets[m]) << t.shift[f]
            if t.word[f]:
                y ^= d
            else:
                x ^= d
            begins, zones, kinds = begins | t.move_sets[m + 1], zones | t.move_sets[m + 2], kinds | t.move_sets[m + 3]
        tried = add_steps(t, x, y, ended, begins, zones, kinds, tried)
        if tried < 0:
            return -1
        road = 0
        while road < roads:
            f = fixed[ROAD_FIELD] + road
            conf = (was_y if t.word[f] else was_x) >> t.shift[f] & t.mask[f]
            seen[chosen + road] += 1
            if seen[chosen + road] < t.confs[conf * fixed[CONF_WIDTH] + C_MOVE_SETS]:
                break
            seen[chosen + road] = 0
            road += 1
        if road == roads:
            return tried


def add_steps(t: Tables, x: int, y: int, ended: int, begins: int, zones: int, kinds: int, tried: int) -> int:
    """Adds the steps after robots moved: with faults or without, and then the ticks of all agents."""
    regs, after = t.regs, t.after
    head = find_ticks(t, x, y, regs[SEEK] >= 0)
    if head < 0:
        return -1
    first = t.after_heads[head + 2]
    count = t.after_heads[head + 3]
    if tried + count > MOST_TRIED:
        regs[CODE] = TOO_MANY
        return -1
    progress, came = t.line[ended * LINE + 5], kinds
    for row in range(first * AFTER, (first + count) * AFTER, AFTER):
        ticks, nx, ny = after[row + 2], after[row], after[row + 1]
        taken = intern_taken(t, ticks, begins, progress, zones, after[row + 5])
        if taken < 0 or not emit_unique(t, nx, ny, taken, came | after[row + 3]):
            return -1
        if regs[SEEK] == regs[NEXTS] - 1:
            write_events(t, ended, after[row + 4])
            return -1
    return tried + count


def emit_unique(t: Tables, x: int, y: int, taken: int, kinds: int) -> bool:
    """Adds a step unless one leads to the same state with the same progress; returns False if there is no room."""
    regs = t.regs
    count = regs[NEXTS]
    h = ((x ^ taken) * MULTIPLIER ^ y * OTHER_MULTIPLIER) & ALL_BITS
    last = len(t.next_slots) - 1
    at = h >> 31 & last
    while t.next_slots[at] != 0:
        n = t.next_slots[at] - 1
        if t.next_x[n] == x and t.next_y[n] == y and t.next_taken[n] == taken:
            return True
        at = at + 1 & last
    if count >= len(t.next_x) or 2 * count >= len(t.next_slots):
        regs[CODE] = ROOM_NEXT
        return False
    t.next_slots[at] = count + 1
    t.next_x[count], t.next_y[count], t.next_taken[count], t.next_event[count] = x, y, taken, at
    t.next_kinds[count] = kinds
    regs[NEXTS] = count + 1
    return True


def intern_taken(t: Tables, ticks: int, begins: int, ends: int, zones: int, passed: int) -> int:
    """The number of a set of progress classes."""
    slots, taken, regs = t.taken_slots, t.taken, t.regs
    h = (ticks * 7 + begins * 31 + ends * 127 + zones + passed * 511) * MULTIPLIER & ALL_BITS
    last = len(slots) - 1
    at = h >> 31 & last
    while slots[at] != 0:
        row = (slots[at] - 1) * TAKEN_WIDTH
        same = taken[row] == ticks and taken[row + 1] == begins and taken[row + 2] == ends
        if same and taken[row + 3] == zones and taken[row + 4] == passed:
            return slots[at] - 1
        at = at + 1 & last
    if regs[IS_WORKER]:
        regs[CODE] = MISS_AS_WORKER
        return -1
    number = regs[TAKEN]
    row = number * TAKEN_WIDTH
    if row + TAKEN_WIDTH > len(taken):
        regs[CODE] = TOO_MANY
        return -1
    taken[row], taken[row + 1], taken[row + 2], taken[row + 3], taken[row + 4] = ticks, begins, ends, zones, passed
    slots[at] = number + 1
    regs[TAKEN] = number + 1
    return number


def write_events(t: Tables, ended: int, faulted: int) -> None:
    """Writes the events of a step into `events`, and their number into `regs`."""
    fixed = t.fixed
    room = len(t.events)
    count = 0
    at = faulted
    while at > 0 and count < room:
        t.events[count] = t.faults[at * LINE + 2]
        count += 1
        at = t.faults[at * LINE + 3]
    decode(t, t.line[ended * LINE], t.line[ended * LINE + 1])
    for road in range(fixed[ROADS] - 1, -1, -1):
        conf = t.now[fixed[ROAD_FIELD] + road]
        m = (t.confs[conf * fixed[CONF_WIDTH] + C_MOVE_SET] + t.seen[3 * fixed[AGENTS] + road]) * MOVE_SET
        for n in range(t.move_sets[m + 5] - 1, -1, -1):
            if count < room:
                t.events[count] = t.log[t.move_sets[m + 4] + n]
                count += 1
    at = ended
    while at > 0 and count < room:
        t.events[count] = t.line[at * LINE + 2]
        count += 1
        at = t.line[at * LINE + 3]
    # They were written from the last to the first.
    for n in range(count // 2):
        t.events[n], t.events[count - 1 - n] = t.events[count - 1 - n], t.events[n]
    t.regs[FOUND] = count
