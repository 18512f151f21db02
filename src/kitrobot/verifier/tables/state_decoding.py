"""Decodes a state, and looks up what its agents can do in it; emits the steps out of it.

A tick is looked up in `reaction_at` by the agent's own state and a few bits of what it senses. -1 means that a table
lacks an entry (`regs[CODE]` says which one): the caller adds it and calls again. This module uses only the subset of
Python that Numba compiles.
"""

from __future__ import annotations

from kitrobot.verifier.tables.columns import (
    A_BED,
    A_PLACE,
    A_ROAD,
    A_VISIT,
    A_VISITS,
    AGENT,
    AGENTS,
    ALL_BITS,
    C_STAND,
    CODE,
    CONF_WIDTH,
    DOCKS,
    E_KIND,
    FIELDS,
    G_STOCK,
    HOUSES,
    I_LOAD,
    INSIDE_STRIDE,
    INSIDE_WIDTH,
    MISS_A,
    MISS_B,
    MISS_REACTION,
    MISS_SHARED,
    MULTIPLIER,
    NEXTS,
    OUTCOME,
    ROAD_FIELD,
    ROOM_NEXT,
    S_AGENT,
    S_COUNT,
    S_MUTE,
    S_VIEW,
    S_VISITS,
    S_WRITE,
    SHARED_WIDTH,
    VISIT,
)
from kitrobot.verifier.tables.tables import Tables, find
from kitrobot.verifier.tables.traffic import conf_after_tick


def decode(t: Tables, x: int, y: int) -> None:
    """Writes the fields of a key into `now`, and behind them the loaded agents, as bits."""
    now, word, shift, mask, agents = t.now, t.word, t.shift, t.mask, t.agents
    for f in range(t.fixed[FIELDS]):
        now[f] = (y if word[f] else x) >> shift[f] & mask[f]
    loaded = 0
    stride, width = t.fixed[INSIDE_STRIDE], t.fixed[INSIDE_WIDTH]
    for i in range(t.fixed[AGENTS]):
        if agents[i * AGENT + A_BED] and t.insides[(i * stride + now[1 + i]) * width + I_LOAD]:
            loaded |= 1 << i
    now[t.fixed[FIELDS]] = loaded


def with_field(t: Tables, f: int, before: int, after: int, x: int, y: int) -> tuple[int, int]:
    """A key after one of its fields changed."""
    d = (before ^ after) << t.shift[f]
    return (x, y ^ d) if t.word[f] else (x ^ d, y)


def sense_key(t: Tables, i: int) -> int:
    """The key of agent i's reaction in the state of `now`: everything that decides its tick, and its stored values."""
    fixed, now, agents = t.fixed, t.now, t.agents
    a = i * AGENT
    key = now[1 + i] | i << S_AGENT | t.shared[now[0] * fixed[SHARED_WIDTH] + G_STOCK + fixed[HOUSES] + i]
    road = agents[a + A_ROAD]
    if road >= 0:
        row = now[fixed[ROAD_FIELD] + road] * fixed[CONF_WIDTH]
        key |= t.confs[row + C_STAND + fixed[DOCKS] + agents[a + A_PLACE]]
    for n in range(agents[a + A_VISITS]):
        v = (agents[a + A_VISIT] + n) * VISIT
        road = t.visits[v + 1]
        if road >= 0:
            there = t.confs[now[fixed[ROAD_FIELD] + road] * fixed[CONF_WIDTH] + C_STAND + t.visits[v]]
            load = t.visits[v + 2]
            if load == 1:
                there &= now[fixed[FIELDS]]
            elif load == 0:
                there &= ~now[fixed[FIELDS]]
            if there:
                key |= 1 << S_VISITS + n
    return key


def find_reactions(t: Tables, i: int) -> int:
    """The possible outcomes of a tick of agent i in the state of `now`: rows of `outcomes` (see `S_COUNT`)."""
    return look_up_reaction(t, i, sense_key(t, i))


def find_silenced(t: Tables, i: int, fails: int) -> int:
    """The number of agent i's own state once it hears nobody, and, if it `fails` (1), has failed.

    It stores the shared variables as it last saw them in the state of `now`.
    """
    fixed, now = t.fixed, t.now
    seen = t.shared[now[0] * fixed[SHARED_WIDTH] + G_STOCK + fixed[HOUSES] + i]
    return look_up_reaction(t, i, 1 << S_MUTE | i << S_AGENT | fails << S_VIEW | seen | now[1 + i])


def look_up_reaction(t: Tables, i: int, key: int) -> int:
    """The value of `reaction_at` for a key of agent i; -1 if it is missing."""
    keys = t.reaction_keys
    last = len(keys) - 1
    at = (key * MULTIPLIER & ALL_BITS) >> 31 & last
    while keys[at] != key:
        if keys[at] < 0:
            t.regs[CODE], t.regs[MISS_A], t.regs[MISS_B] = MISS_REACTION, i, key
            return -1
        at = at + 1 & last
    return t.reaction_at[at]


def look_up_change(t: Tables, number: int, write: int) -> int:
    """The number of the shared state after a write; -1 if it is missing."""
    key = number << S_WRITE | write
    at = find(t.change_keys, key)
    if t.change_keys[at] < 0:
        t.regs[CODE], t.regs[MISS_A], t.regs[MISS_B] = MISS_SHARED, number, write
        return -1
    return t.change_to[at]


def may_idle(t: Tables, i: int) -> int:
    """Whether a tick of agent i may change nothing in the state of `now`: 1, 0, or -1 if an entry is missing."""
    got = find_reactions(t, i)
    if got < 0:
        return -1
    road = t.agents[i * AGENT + A_ROAD]
    for o in range(got >> S_COUNT, (got >> S_COUNT) + (got & (1 << S_COUNT) - 1)):
        if t.outcomes[o * OUTCOME] == t.now[1 + i] and t.outcomes[o * OUTCOME + 2] == 0:
            if road < 0:
                return 1
            conf = t.now[t.fixed[ROAD_FIELD] + road]
            to = conf_after_tick(t, conf, t.agents[i * AGENT + A_PLACE], t.outcomes[o * OUTCOME + 1])
            if to < 0:
                return -1
            if to == conf:
                return 1
    return 0


def emit_step(t: Tables, x: int, y: int, event: int, taken: int) -> bool:
    """Adds a step of one event; returns False if there is no room."""
    count = t.regs[NEXTS]
    if count >= len(t.next_x):
        t.regs[CODE] = ROOM_NEXT
        return False
    t.next_x[count], t.next_y[count], t.next_event[count], t.next_taken[count] = x, y, event, taken
    t.next_kinds[count] = 1 << (event & E_KIND)
    t.regs[NEXTS] = count + 1
    return True
