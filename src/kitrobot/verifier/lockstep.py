"""The steps of *lockstep*: what takes longer ends, robots move, something befalls agents, and all tick at once.

What is here is in the part of Python that Numba takes; -1 says as in `stepping`.
"""

from __future__ import annotations

from kitrobot.verifier.columns import (
    A_PLACE,
    A_ROAD,
    AGENT,
    AGENTS,
    ALL_BITS,
    C_MOMENT,
    C_MOMENTS,
    CODE,
    CONF_WIDTH,
    E_AGENT,
    E_KIND,
    E_MASK,
    FOUND,
    I_ENDS,
    I_TICKS,
    INSIDE_STRIDE,
    INSIDE_WIDTH,
    LINE,
    MAY_FAIL,
    MOMENT,
    MULTIPLIER,
    NEXTS,
    OTHER_MULTIPLIER,
    OUTCOME,
    ROAD_FIELD,
    ROADS,
    ROOM_NEXT,
    S_COUNT,
    SEEK,
    SLOWER,
    TAKEN,
    TAKEN_WIDTH,
    TOO_MANY,
)
from kitrobot.verifier.events import MOST_AT_ONCE
from kitrobot.verifier.happening import ends_of, harms_of
from kitrobot.verifier.looking import changed, decode, react
from kitrobot.verifier.moments import fill_moments
from kitrobot.verifier.tables import Tables
from kitrobot.verifier.traffic import after_tick

MOST_TRIED = 20_000_000
"""Ways out of one state that are tried at most, those that come to the same counted apart."""


def expand_lockstep(t: Tables, x: int, y: int) -> int:
    """Finds the steps out of a state; of those that lead to the same one with the same progress one is kept."""
    regs, fixed, line = t.regs, t.fixed, t.line
    for n in range(regs[NEXTS]):
        t.next_slots[t.next_event[n]] = 0
    regs[NEXTS] = 0
    regs[FOUND] = -1
    line[0], line[1], line[2], line[3], line[4], line[5] = x, y, 0, -1, 0, 0
    count, at, tried = 1, 0, 0
    while at < count:
        decode(t, line[at * LINE], line[at * LINE + 1])
        last = -1 if at == 0 else line[at * LINE + 2] >> E_AGENT & E_MASK
        for i in range(last + 1, fixed[AGENTS]):
            row = (i * fixed[INSIDE_STRIDE] + t.now[1 + i]) * fixed[INSIDE_WIDTH]
            if not t.insides[row + I_ENDS]:
                continue
            found = ends_of(t, line[at * LINE], line[at * LINE + 1], i, count)
            if found < 0:
                return -1
            for n in range(count, count + found):
                line[n * LINE + 3] = at
                line[n * LINE + 4] = line[at * LINE + 4] | 1 << (line[n * LINE + 2] & E_KIND)
                line[n * LINE + 5] = line[at * LINE + 5] | 1 << i
            count += found
        tried = move_all(t, at, tried)
        if tried < 0:
            return -1
        at += 1
    return regs[NEXTS]


def move_all(t: Tables, ended: int, tried: int) -> int:
    """After the ends of a row of `line`: every way in which the robots of all roads move, and then all tick.

    `seen` has, behind the reactions of the agents and their choices, of each road which way is taken.
    """
    fixed, now, seen = t.fixed, t.now, t.seen
    roads, n = fixed[ROADS], fixed[AGENTS]
    chosen = 3 * n
    for road in range(roads):
        decode(t, t.line[ended * LINE], t.line[ended * LINE + 1])
        conf = now[fixed[ROAD_FIELD] + road]
        if t.confs[conf * fixed[CONF_WIDTH] + C_MOMENTS] < 0 and fill_moments(t, conf) < 0:
            return -1
        if t.confs[conf * fixed[CONF_WIDTH] + C_MOMENTS] == 0:
            return tried
        seen[chosen + road] = 0
    while True:
        x, y = t.line[ended * LINE], t.line[ended * LINE + 1]
        decode(t, x, y)
        kinds, begins, zones = t.line[ended * LINE + 4], 0, 0
        for road in range(roads):
            f = fixed[ROAD_FIELD] + road
            m = (t.confs[now[f] * fixed[CONF_WIDTH] + C_MOMENT] + seen[chosen + road]) * MOMENT
            d = (now[f] ^ t.moments[m]) << t.shift[f]
            if t.word[f]:
                y ^= d
            else:
                x ^= d
            begins, zones, kinds = begins | t.moments[m + 1], zones | t.moments[m + 2], kinds | t.moments[m + 3]
        tried = befall_all(t, x, y, ended, begins, zones, kinds, tried)
        if tried < 0:
            return -1
        decode(t, t.line[ended * LINE], t.line[ended * LINE + 1])
        road = 0
        while road < roads:
            seen[chosen + road] += 1
            if seen[chosen + road] < t.confs[now[fixed[ROAD_FIELD] + road] * fixed[CONF_WIDTH] + C_MOMENTS]:
                break
            seen[chosen + road] = 0
            road += 1
        if road == roads:
            return tried


def befall_all(t: Tables, x: int, y: int, ended: int, begins: int, zones: int, kinds: int, tried: int) -> int:
    """After robots moved: nothing befalls anybody, or something some agents; then all tick."""
    fixed, harm = t.fixed, t.harm
    harm[0], harm[1], harm[2], harm[3], harm[4] = x, y, 0, -1, kinds
    count, at = 1, 0
    while at < count:
        nx, ny = harm[at * LINE], harm[at * LINE + 1]
        if fixed[MAY_FAIL]:
            decode(t, nx, ny)
            last = -1 if at == 0 else harm[at * LINE + 2] >> E_AGENT & E_MASK
            for i in range(last + 1, fixed[AGENTS]):
                found = harms_of(t, nx, ny, i, count)
                if found < 0:
                    return -1
                for n in range(count, count + found):
                    harm[n * LINE + 3] = at
                    harm[n * LINE + 4] = harm[at * LINE + 4] | 1 << (harm[n * LINE + 2] & E_KIND)
                count += found
        tried = tick_all(t, nx, ny, ended, at, begins, zones, tried)
        if tried < 0:
            return -1
        at += 1
    return tried


def tick_all(t: Tables, x: int, y: int, ended: int, harmed: int, begins: int, zones: int, tried: int) -> int:
    """A tick of all agents; those whose ticks are longer than others' may have none."""
    fixed, seen, insides = t.fixed, t.seen, t.insides
    n, slower = fixed[AGENTS], fixed[SLOWER]
    decode(t, x, y)
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
            if not tick_once(t, x, y, paused, ended, harmed, begins, zones):
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


def tick_once(t: Tables, x: int, y: int, paused: int, ended: int, harmed: int, begins: int, zones: int) -> bool:
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
    x ^= (now[0] ^ shared) << t.shift[0]
    for road in range(fixed[ROADS]):
        f = fixed[ROAD_FIELD] + road
        d = (now[f] ^ seen[3 * n + fixed[ROADS] + road]) << t.shift[f]
        if t.word[f]:
            y ^= d
        else:
            x ^= d
    return emit_once(t, x, y, fixed[SLOWER] & ~paused, ended, harmed, begins, zones)


def emit_once(t: Tables, x: int, y: int, ticks: int, ended: int, harmed: int, begins: int, zones: int) -> bool:
    """Adds a step unless there is one to the same state with the same progress; False where there is no room."""
    regs = t.regs
    taken = intern_taken(t, ticks, begins, t.line[ended * LINE + 5], zones)
    if taken < 0:
        return False
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
    t.next_kinds[count] = t.harm[harmed * LINE + 4]
    regs[NEXTS] = count + 1
    if regs[SEEK] == count:
        tell(t, ended, harmed)
        return False
    return True


def intern_taken(t: Tables, ticks: int, begins: int, ends: int, zones: int) -> int:
    """The number of a set of progress classes."""
    slots, taken, regs = t.taken_slots, t.taken, t.regs
    h = (ticks * 7 + begins * 31 + ends * 127 + zones) * MULTIPLIER & ALL_BITS
    last = len(slots) - 1
    at = h >> 31 & last
    while slots[at] != 0:
        row = (slots[at] - 1) * TAKEN_WIDTH
        if taken[row] == ticks and taken[row + 1] == begins and taken[row + 2] == ends and taken[row + 3] == zones:
            return slots[at] - 1
        at = at + 1 & last
    number = regs[TAKEN]
    row = number * TAKEN_WIDTH
    if row + TAKEN_WIDTH > len(taken):
        regs[CODE] = TOO_MANY
        return -1
    taken[row], taken[row + 1], taken[row + 2], taken[row + 3] = ticks, begins, ends, zones
    slots[at] = number + 1
    regs[TAKEN] = number + 1
    return number


def tell(t: Tables, ended: int, harmed: int) -> None:
    """Writes the events of a step into `events`; how many there are into `regs`."""
    fixed = t.fixed
    room = len(t.events)
    count = 0
    at = harmed
    while at > 0 and count < room:
        t.events[count] = t.harm[at * LINE + 2]
        count += 1
        at = t.harm[at * LINE + 3]
    decode(t, t.line[ended * LINE], t.line[ended * LINE + 1])
    for road in range(fixed[ROADS] - 1, -1, -1):
        conf = t.now[fixed[ROAD_FIELD] + road]
        m = (t.confs[conf * fixed[CONF_WIDTH] + C_MOMENT] + t.seen[3 * fixed[AGENTS] + road]) * MOMENT
        for n in range(t.moments[m + 5] - 1, -1, -1):
            if count < room:
                t.events[count] = t.log[t.moments[m + 4] + n]
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
