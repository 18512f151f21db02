"""Simultaneous ticks of several agents, in *prompt* and *free*: only those that no order of single ticks leads to.

Agents that tick in the same moment read the values before it; if several write, the write of the agent that is later in
the team wins. If the write of agent i changes nothing that agent j does, the result is that of i and then j; likewise
for j and then i, if the order of their writes makes no difference. What is left are agents that each read what another
one writes in this very moment, as the two of Peterson's algorithm do when they enter at once.

A set of agents is skipped if it can be split in two, one part after the other. This module uses only the subset of
Python that Numba compiles; False means the same as -1 in `interleaved_successors`.
"""

from __future__ import annotations

from kitrobot.verifier.tables.columns import (
    A_PLACE,
    A_ROAD,
    AGENT,
    AGENTS,
    CODE,
    E_AGENT,
    G_STOCK,
    HOUSES,
    IS_WORKER,
    MISS_AS_WORKER,
    OUTCOME,
    ROAD_FIELD,
    ROADS,
    S_COUNT,
    S_SHARED,
    S_VIEW,
    SHARED_WIDTH,
    TAKEN,
    TAKEN_WIDTH,
    TOO_MANY,
)
from kitrobot.verifier.tables.events import MOST_AT_ONCE, TICK
from kitrobot.verifier.tables.state_decoding import (
    emit_step,
    find_reactions,
    look_up_change,
    look_up_reaction,
    sense_key,
)
from kitrobot.verifier.tables.tables import Tables
from kitrobot.verifier.tables.traffic import conf_after_tick

MOST_WRITERS = 14
"""The most agents that may write, in one moment, a value that others read in it."""
MOST_TOGETHER = 4096
"""Sets of agents that tick in one moment, in one mission."""
_SEEN = (1 << S_VIEW) - (1 << S_SHARED)
"""The bits of a reaction's key with the agent's view of the shared state."""


def add_simultaneous_ticks(t: Tables, x: int, y: int, writers: int) -> bool:
    """Adds the ticks in one moment of sets of these agents, as bits, whose ticks may write something.

    `seen` has, for each agent, the row of `outcomes` that is chosen.
    """
    conflicts = may_conflict(t, writers)
    if conflicts < 0:
        return False
    if conflicts == 0:
        return True
    count = 0
    for i in range(t.fixed[AGENTS]):
        count += writers >> i & 1
    if count > MOST_WRITERS:
        t.regs[CODE] = TOO_MANY
        return False
    tried = 0
    who = writers
    while who > 0:
        if who & who - 1:
            more = first_choice(t, who)
            while more:
                tried += 1
                if tried > MOST_AT_ONCE:
                    t.regs[CODE] = TOO_MANY
                    return False
                apart = is_serializable(t, who)
                if apart < 0 or (apart == 0 and not emit_simultaneous(t, x, y, who)):
                    return False
                more = next_choice(t, who)
        who = who - 1 & writers
    return True


def may_conflict(t: Tables, writers: int) -> int:
    """Whether one of these agents may write what one that stands later in the team sees: else no tick in one moment is
    anything new.
    """
    for i in range(t.fixed[AGENTS]):
        if writers >> i & 1 == 0:
            continue
        got = find_reactions(t, i)
        first = got >> S_COUNT
        for o in range(first, first + (got & (1 << S_COUNT) - 1)):
            if t.outcomes[o * OUTCOME + 2]:
                after = look_up_change(t, t.now[0], t.outcomes[o * OUTCOME + 2])
                if after < 0:
                    return -1
                for j in range(i + 1, t.fixed[AGENTS]):
                    if writers >> j & 1 and shared_view(t, j, after) != shared_view(t, j, t.now[0]):
                        return 1
    return 0


def shared_view(t: Tables, i: int, shared: int) -> int:
    """Agent i's view of a shared state, given by its number."""
    return t.shared[shared * t.fixed[SHARED_WIDTH] + G_STOCK + t.fixed[HOUSES] + i]


def first_choice(t: Tables, who: int) -> bool:
    """Chooses, for each of these agents, the first outcome with a write."""
    for i in range(t.fixed[AGENTS]):
        if who >> i & 1:
            t.seen[i] = find_reactions(t, i) >> S_COUNT
            while not t.outcomes[t.seen[i] * OUTCOME + 2]:
                t.seen[i] += 1
    return True


def next_choice(t: Tables, who: int) -> bool:
    """Advances to the next choice; returns False after the last one."""
    for i in range(t.fixed[AGENTS]):
        if who >> i & 1:
            got = find_reactions(t, i)
            end = (got >> S_COUNT) + (got & (1 << S_COUNT) - 1)
            t.seen[i] += 1
            while t.seen[i] < end and not t.outcomes[t.seen[i] * OUTCOME + 2]:
                t.seen[i] += 1
            if t.seen[i] < end:
                return True
            t.seen[i] = got >> S_COUNT
            while not t.outcomes[t.seen[i] * OUTCOME + 2]:
                t.seen[i] += 1
    return False


def is_serializable(t: Tables, who: int) -> int:
    """Whether the chosen ticks come to what these agents come to one after another, in parts.

    Of two it is known; of more a part is taken to come first only where nothing of it is seen by those that follow.
    """
    n, count, first, last = t.fixed[AGENTS], 0, -1, -1
    for i in range(n):
        if who >> i & 1:
            first, last = (i, last) if first < 0 else (first, i)
            count += 1
    if count == 2:
        return are_serializable(t, first, last)
    furthest = -1
    for i in range(n):
        if who >> i & 1 == 0:
            continue
        after = look_up_change(t, t.now[0], t.outcomes[t.seen[i] * OUTCOME + 2])
        if after < 0:
            return -1
        for j in range(i + 1, n):
            if who >> j & 1 and j > furthest and shared_view(t, j, after) != shared_view(t, j, t.now[0]):
                furthest = j
        if i != last and furthest <= i:
            return 1
    return 0


def are_serializable(t: Tables, i: int, j: int) -> int:
    """The same for two agents; i is earlier in the team."""
    first, second = t.outcomes[t.seen[i] * OUTCOME + 2], t.outcomes[t.seen[j] * OUTCOME + 2]
    after_first, after_second = look_up_change(t, t.now[0], first), look_up_change(t, t.now[0], second)
    if after_first < 0 or after_second < 0:
        return -1
    does_the_same = has_same_outcome(t, j, after_first)
    if does_the_same:
        return does_the_same
    does_the_same = has_same_outcome(t, i, after_second)
    if does_the_same <= 0:
        return does_the_same
    both, other = look_up_change(t, after_first, second), look_up_change(t, after_second, first)
    if both < 0 or other < 0:
        return -1
    return 1 if both == other else 0


def has_same_outcome(t: Tables, i: int, shared: int) -> int:
    """Whether the chosen outcome of agent i is one of those that it has where this is shared."""
    outcomes = t.outcomes
    key = sense_key(t, i) & ~_SEEN | shared_view(t, i, shared)
    got = look_up_reaction(t, i, key)
    if got < 0:
        return -1
    chosen = t.seen[i] * OUTCOME
    for o in range(got >> S_COUNT, (got >> S_COUNT) + (got & (1 << S_COUNT) - 1)):
        row = o * OUTCOME
        is_same = outcomes[row] == outcomes[chosen] and outcomes[row + 1] == outcomes[chosen + 1]
        if is_same and outcomes[row + 2] == outcomes[chosen + 2]:
            return 1
    return 0


def emit_simultaneous(t: Tables, x: int, y: int, who: int) -> bool:
    """Adds the step in which these agents have the ticks that are chosen."""
    fixed, now, seen = t.fixed, t.now, t.seen
    n, shared, first = fixed[AGENTS], now[0], -1
    confs = 3 * n
    for road in range(fixed[ROADS]):
        seen[confs + road] = now[fixed[ROAD_FIELD] + road]
    for i in range(n):
        if who >> i & 1 == 0:
            continue
        first = i if first < 0 else first
        o = seen[i] * OUTCOME
        d = (now[1 + i] ^ t.outcomes[o]) << t.shift[1 + i]
        x, y = (x, y ^ d) if t.word[1 + i] else (x ^ d, y)
        shared = look_up_change(t, shared, t.outcomes[o + 2])
        if shared < 0:
            return False
        road = t.agents[i * AGENT + A_ROAD]
        if road >= 0:
            to = conf_after_tick(t, seen[confs + road], t.agents[i * AGENT + A_PLACE], t.outcomes[o + 1])
            if to < 0:
                return False
            seen[confs + road] = to
    x ^= (now[0] ^ shared) << t.shift[0]
    for road in range(fixed[ROADS]):
        f = fixed[ROAD_FIELD] + road
        d = (now[f] ^ seen[confs + road]) << t.shift[f]
        x, y = (x, y ^ d) if t.word[f] else (x ^ d, y)
    taken = intern_tick_set(t, who)
    return taken >= 0 and emit_step(t, x, y, TICK | first << E_AGENT, taken)


def intern_tick_set(t: Tables, who: int) -> int:
    """The number of the progress of these agents' ticks."""
    regs, taken = t.regs, t.taken
    number = 1 + TAKEN_WIDTH * t.fixed[AGENTS]
    while number < regs[TAKEN] and taken[number * TAKEN_WIDTH] != who:
        number += 1
    if (number + 1) * TAKEN_WIDTH > len(taken):
        regs[CODE] = TOO_MANY
        return -1
    if number == regs[TAKEN]:
        if regs[IS_WORKER]:
            regs[CODE] = MISS_AS_WORKER
            return -1
        taken[number * TAKEN_WIDTH] = who
        regs[TAKEN] = number + 1
    return number
