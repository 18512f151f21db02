"""The ticks of *lockstep*: after robots moved, faults occur or do not, and all agents tick at once.

Many moves lead to the same state, so the results are cached in `after` and computed once for each state as long as
there is room. This module uses only the subset of Python that Numba compiles; -1 means the same as in
`interleaved_successors`.
"""

from __future__ import annotations

from kitrobot.verifier.absence_detection import watch
from kitrobot.verifier.bodies import STALLED
from kitrobot.verifier.columns import (
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
from kitrobot.verifier.events import MOST_AT_ONCE, RESUME, STALL
from kitrobot.verifier.state_decoding import changed, decode, react
from kitrobot.verifier.tables import Tables
from kitrobot.verifier.traffic import after_tick
from kitrobot.verifier.world_transitions import MUTES, RESUMES, harms_of

MOST_TRIED = 20_000_000
"""Ways out of one state that are tried at most, those that come to the same counted apart."""


def after_all(t: Tables, x: int, y: int, is_sought: bool) -> int:
    """Where in `after_heads` that is which may follow once robots moved: it is found, or worked out and kept.

    What befell agents is in `harm` only where it `is_sought`: then it is worked out anew.
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
    if not befall_all(t, x, y):
        regs[AFTER_ROWS] = first
        return -1
    slots[at] = number + 1
    heads[head], heads[head + 1], heads[head + 2], heads[head + 3] = x, y, first, regs[AFTER_ROWS] - first
    regs[AFTERS] = number + 1
    return head


def befall_all(t: Tables, x: int, y: int) -> bool:
    """Nothing befalls anybody, or something some agents; then all tick. False where something is missing."""
    fixed, harm, insides = t.fixed, t.harm, t.insides
    harm[0], harm[1], harm[2], harm[3], harm[4], harm[5] = x, y, 0, -1, 0, 0
    count, at, tried = 1, 0, 0
    while at < count:
        nx, ny = harm[at * LINE], harm[at * LINE + 1]
        decode(t, nx, ny)
        if fixed[MAY_FAIL]:
            last = -1 if at == 0 else harm[at * LINE + 2] >> E_AGENT & E_MASK
            left = t.shared[t.now[0] * fixed[SHARED_WIDTH] + G_FAILURES]
            # Who goes on or stalls may lose its radio in the same moment.
            is_more = at > 0 and harm[at * LINE + 2] & E_KIND in (RESUME, STALL)
            for i in range(last if is_more else last + 1, fixed[AGENTS]):
                row = (i * fixed[INSIDE_STRIDE] + t.now[1 + i]) * fixed[INSIDE_WIDTH]
                if left == 0 and insides[row + I_DOWN] != STALLED:
                    continue
                found = harms_of(t, nx, ny, i, count, MUTES if i == last else RESUMES)
                if found < 0:
                    return False
                for n in range(count, count + found):
                    harm[n * LINE + 3] = at
                    harm[n * LINE + 4] = harm[at * LINE + 4] | 1 << (harm[n * LINE + 2] & E_KIND)
                    harm[n * LINE + 5] = 0
                count += found
        if not fixed[WATCHED]:
            tried = tick_all(t, nx, ny, at, tried)
            if tried < 0:
                return False
        at += 1
    return fixed[WATCHED] == 0 or watch_all(t, count)


def watch_all(t: Tables, count: int) -> bool:
    """After each of so many rows of `harm`: every way in which a team may miss agents, or not yet; then all tick."""
    harm, tried, room = t.harm, 0, count
    for at in range(count):
        chosen = choices = 0
        while chosen >> choices == 0:
            rows = watch(t, at, room, chosen)
            if rows < 0:
                return False
            choices = t.regs[CHOICES]
            last = room + max(rows, 1) - 1
            x, y = harm[last * LINE], harm[last * LINE + 1]
            decode(t, x, y)
            tried = tick_all(t, x, y, last if rows else at, tried)
            if tried < 0:
                return False
            room += rows
            chosen += 1
    return True


def tick_all(t: Tables, x: int, y: int, harmed: int, tried: int) -> int:
    """A tick of all agents in the state of `now`; those whose ticks are longer than others' may have none."""
    fixed, seen, insides = t.fixed, t.seen, t.insides
    n, slower = fixed[AGENTS], fixed[SLOWER]
    for i in range(n):
        seen[i] = 0
        if insides[(i * fixed[INSIDE_STRIDE] + t.now[1 + i]) * fixed[INSIDE_WIDTH] + I_TICKS]:
            got = react(t, i)
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
            if not tick_once(t, x, y, paused, harmed):
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


def tick_once(t: Tables, x: int, y: int, paused: int, harmed: int) -> bool:
    """Adds the step in which each agent has the reaction that is chosen; False where something is missing."""
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
            shared = changed(t, shared, t.outcomes[o + 2])
            if shared < 0:
                return False
        road = t.agents[i * AGENT + A_ROAD]
        if road >= 0:
            at = 3 * n + fixed[ROADS] + road
            to = after_tick(t, seen[at], t.agents[i * AGENT + A_PLACE], t.outcomes[o + 1])
            if to < 0:
                return False
            seen[at] = to
    if fixed[SETTLES]:
        shared = changed(t, shared, 2 + 2 * fixed[HOUSES])
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
    after[row + 3], after[row + 4], after[row + 5] = t.harm[harmed * LINE + 4], harmed, t.harm[harmed * LINE + 5]
    regs[AFTER_ROWS] += 1
    return True
