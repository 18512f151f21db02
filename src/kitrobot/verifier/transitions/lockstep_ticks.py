"""The ticks of *lockstep*: after robots moved, faults occur or do not, and all agents tick at once.

Many moves lead to the same state, so the results are cached in `after` and computed once for each state as long as
there is room. This module uses only the subset of Python that Numba compiles; -1 means the same as in
`interleaved_successors`.
"""

from __future__ import annotations

from kitrobot.verifier.tables.bodies import STALLED
from kitrobot.verifier.tables.columns import (
    A_PLACE,
    A_ROAD,
    AFTER,
    AFTER_HEAD,
    AFTER_ROWS,
    AFTERS,
    AGENT,
    AGENTS,
    ALL_BITS,
    CHOICES,
    CODE,
    E_AGENT,
    E_KIND,
    E_MASK,
    G_FAILURES,
    HOUSES,
    I_DOWN,
    I_TICKS,
    INSIDE_STRIDE,
    INSIDE_WIDTH,
    LINE,
    MAY_FAIL,
    MULTIPLIER,
    OTHER_MULTIPLIER,
    OUTCOME,
    ROAD_FIELD,
    ROADS,
    ROOM_AFTERS,
    S_COUNT,
    SETTLES,
    SHARED_WIDTH,
    SLOWER,
    TOO_MANY,
    WATCHED,
)
from kitrobot.verifier.tables.events import MOST_AT_ONCE, RESUME, STALL
from kitrobot.verifier.tables.state_decoding import decode, find_reactions, look_up_change
from kitrobot.verifier.tables.tables import Tables
from kitrobot.verifier.tables.traffic import conf_after_tick
from kitrobot.verifier.transitions.absence_detection import detect_absences
from kitrobot.verifier.transitions.world_transitions import MUTES, RESUMES, write_faults

MOST_TRIED = 20_000_000
"""The most combinations tried out of one state; those with the same result count separately."""


def find_ticks(t: Tables, x: int, y: int, is_sought: bool) -> int:
    """The place in `after_heads` of the ticks after robots moved: from the cache, or computed and stored.

    `faults` holds the faults of agents only if `is_sought`, which computes them again.
    """
    regs, heads, slots = t.regs, t.after_heads, t.after_slots
    last = len(slots) - 1
    at = (((x ^ x >> 29) * MULTIPLIER ^ y * OTHER_MULTIPLIER) & ALL_BITS) >> 30 & last
    while slots[at] != 0:
        head = (slots[at] - 1) * AFTER_HEAD
        if not is_sought and heads[head] == x and heads[head + 1] == y:
            return head
        at = at + 1 & last
    number, first = regs[AFTERS], regs[AFTER_ROWS]
    head = number * AFTER_HEAD
    if head + AFTER_HEAD > len(heads) or 2 * number >= len(slots):
        regs[CODE] = ROOM_AFTERS
        return -1
    if not combine_faults(t, x, y):
        regs[AFTER_ROWS] = first
        return -1
    slots[at] = number + 1
    heads[head], heads[head + 1], heads[head + 2], heads[head + 3] = x, y, first, regs[AFTER_ROWS] - first
    regs[AFTERS] = number + 1
    return head


def combine_faults(t: Tables, x: int, y: int) -> bool:
    """Adds every combination of faults, none included, and then all ticks; returns False if a table lacks an entry."""
    fixed, faults, insides = t.fixed, t.faults, t.insides
    faults[0], faults[1], faults[2], faults[3], faults[4], faults[5] = x, y, 0, -1, 0, 0
    count, at, tried = 1, 0, 0
    while at < count:
        nx, ny = faults[at * LINE], faults[at * LINE + 1]
        decode(t, nx, ny)
        if fixed[MAY_FAIL]:
            last = -1 if at == 0 else faults[at * LINE + 2] >> E_AGENT & E_MASK
            left = t.shared[t.now[0] * fixed[SHARED_WIDTH] + G_FAILURES]
            # Who goes on or stalls may lose its radio in the same moment.
            is_more = at > 0 and faults[at * LINE + 2] & E_KIND in (RESUME, STALL)
            for i in range(last if is_more else last + 1, fixed[AGENTS]):
                row = (i * fixed[INSIDE_STRIDE] + t.now[1 + i]) * fixed[INSIDE_WIDTH]
                if left == 0 and insides[row + I_DOWN] != STALLED:
                    continue
                found = write_faults(t, nx, ny, i, count, MUTES if i == last else RESUMES)
                if found < 0:
                    return False
                for n in range(count, count + found):
                    faults[n * LINE + 3] = at
                    faults[n * LINE + 4] = faults[at * LINE + 4] | 1 << (faults[n * LINE + 2] & E_KIND)
                    faults[n * LINE + 5] = 0
                count += found
        if not fixed[WATCHED]:
            tried = combine_ticks(t, nx, ny, at, tried)
            if tried < 0:
                return False
        at += 1
    return fixed[WATCHED] == 0 or combine_absences(t, count)


def combine_absences(t: Tables, count: int) -> bool:
    """Adds, after each of `count` rows of `faults`, every combination of absences, and then all ticks."""
    faults, tried, room = t.faults, 0, count
    for at in range(count):
        chosen = choices = 0
        while chosen >> choices == 0:
            rows = detect_absences(t, at, room, chosen)
            if rows < 0:
                return False
            choices = t.regs[CHOICES]
            last = room + max(rows, 1) - 1
            x, y = faults[last * LINE], faults[last * LINE + 1]
            decode(t, x, y)
            tried = combine_ticks(t, x, y, last if rows else at, tried)
            if tried < 0:
                return False
            room += rows
            chosen += 1
    return True


def combine_ticks(t: Tables, x: int, y: int, faulted: int, tried: int) -> int:
    """Adds a tick of all agents in the state of `now`; agents with longer ticks than others may have none."""
    fixed, seen, insides = t.fixed, t.seen, t.insides
    n, slower = fixed[AGENTS], fixed[SLOWER]
    for i in range(n):
        seen[i] = 0
        if insides[(i * fixed[INSIDE_STRIDE] + t.now[1 + i]) * fixed[INSIDE_WIDTH] + I_TICKS]:
            got = find_reactions(t, i)
            if got < 0:
                return -1
            seen[i] = got
    paused, made = 0, 0
    while True:
        for i in range(n):
            seen[2 * n + i] = 0
        i = 0
        while i < n:
            tried += 1
            made += 1
            if tried > MOST_TRIED or made > MOST_AT_ONCE:
                t.regs[CODE] = TOO_MANY
                return -1
            if not emit_tick(t, x, y, paused, faulted):
                return -1
            i = 0
            while i < n:
                seen[2 * n + i] += 1
                if seen[2 * n + i] < seen[i] & (1 << S_COUNT) - 1 and not paused >> i & 1:
                    break
                seen[2 * n + i] = 0
                i += 1
        if paused == slower:
            return tried
        paused = (paused | ~slower) + 1 & slower


def emit_tick(t: Tables, x: int, y: int, paused: int, faulted: int) -> bool:
    """Adds the step in which each agent has the chosen reaction; returns False if a table lacks an entry."""
    fixed, now, seen = t.fixed, t.now, t.seen
    n = fixed[AGENTS]
    shared = now[0]
    for road in range(fixed[ROADS]):
        seen[3 * n + fixed[ROADS] + road] = now[fixed[ROAD_FIELD] + road]
    for i in range(n):
        if seen[i] == 0 or paused >> i & 1:
            continue
        o = ((seen[i] >> S_COUNT) + seen[2 * n + i]) * OUTCOME
        d = (now[1 + i] ^ t.outcomes[o]) << t.shift[1 + i]
        if t.word[1 + i]:
            y ^= d
        else:
            x ^= d
        if t.outcomes[o + 2]:
            shared = look_up_change(t, shared, t.outcomes[o + 2])
            if shared < 0:
                return False
        road = t.agents[i * AGENT + A_ROAD]
        if road >= 0:
            at = 3 * n + fixed[ROADS] + road
            to = conf_after_tick(t, seen[at], t.agents[i * AGENT + A_PLACE], t.outcomes[o + 1])
            if to < 0:
                return False
            seen[at] = to
    if fixed[SETTLES]:
        shared = look_up_change(t, shared, 2 + 2 * fixed[HOUSES])
        if shared < 0:
            return False
    x ^= (now[0] ^ shared) << t.shift[0]
    for road in range(fixed[ROADS]):
        f = fixed[ROAD_FIELD] + road
        d = (now[f] ^ seen[3 * n + fixed[ROADS] + road]) << t.shift[f]
        if t.word[f]:
            y ^= d
        else:
            x ^= d
    regs, after = t.regs, t.after
    row = regs[AFTER_ROWS] * AFTER
    if row + AFTER > len(after):
        regs[CODE] = ROOM_AFTERS
        return False
    after[row], after[row + 1], after[row + 2] = x, y, fixed[SLOWER] & ~paused
    after[row + 3], after[row + 4], after[row + 5] = t.faults[faulted * LINE + 4], faulted, t.faults[faulted * LINE + 5]
    regs[AFTER_ROWS] += 1
    return True
