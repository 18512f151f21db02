"""Absence detection of a team in the model: between the faults of agents and their ticks, as in the simulator.

An agent that is not well is silent from then on. Of the agents that were silent before, each may be missed or not yet;
an agent that is well is heard again. This goes in team order, since a silent agent takes over no role. Before that,
units of work with a lease may become free again or not yet. This module uses only the subset of Python that Numba
compiles; -1 means the same as in `interleaved_successors`.
"""

from __future__ import annotations

from kitrobot.verifier.tables.bodies import ANEW, LOST, RUNS
from kitrobot.verifier.tables.columns import (
    A_PLACE,
    A_ROAD,
    AGENT,
    AGENTS,
    CHOICES,
    CODE,
    E_AGENT,
    G_HOLDING,
    G_MEMBERS,
    G_MISSED,
    G_OVER,
    G_PLAYING,
    G_SILENT,
    G_STOCK,
    HOUSES,
    I_BEFALLEN,
    I_DOWN,
    I_MUTED,
    INSIDE_STRIDE,
    INSIDE_WIDTH,
    LINE,
    MISS_A,
    MISS_B,
    MISS_DOWN,
    ROAD_FIELD,
    SHARED_WIDTH,
    TOO_MANY,
    W_ANEW,
    W_BACK,
    W_FREED,
    W_MISSED,
    W_SILENT,
    WATCHED,
)
from kitrobot.verifier.tables.events import FREED, MISSED
from kitrobot.verifier.tables.state_decoding import decode, look_up_change, with_field
from kitrobot.verifier.tables.tables import Tables
from kitrobot.verifier.tables.traffic import conf_after_fault

MOST_CHOICES = 16
"""Agents that may be missed, and units that may be free again, in one step."""


def team_column(t: Tables, shared: int, column: int) -> int:
    """A column of the shared state, from `G_MEMBERS` on."""
    fixed = t.fixed
    return t.shared[shared * fixed[SHARED_WIDTH] + G_STOCK + fixed[HOUSES] + fixed[AGENTS] + column]


def is_team_over(t: Tables) -> bool:
    """Whether the team cannot continue in the state of `now`."""
    return t.fixed[WATCHED] != 0 and team_column(t, t.now[0], G_OVER) != 0


def after_absence(t: Tables, shared: int, i: int, what: int) -> int:
    """The number of the shared state after an absence event of agent i (`W_SILENT` and the following)."""
    fixed = t.fixed
    return look_up_change(t, shared, 3 + 2 * fixed[HOUSES] + i * (W_FREED + fixed[WATCHED] - 1) + what)


def possible_absences(t: Tables) -> int:
    """The agents that the team may miss in the state of `now`, or whose units may become free, as bits."""
    fixed = t.fixed
    shared = t.now[0]
    found = team_column(t, shared, G_SILENT) & team_column(t, shared, G_PLAYING) & team_column(t, shared, G_MEMBERS)
    for w in range(fixed[WATCHED] - 1):
        found |= team_column(t, shared, G_HOLDING + w)
    return found


def detect_absences(t: Tables, first: int, room: int, chosen: int) -> int:
    """Writes the absence events after a row of `faults` into rows from `room` on, one for each event; returns how many.

    The last row has the key of the state, even if there is no event. `chosen` selects, as bits, which of the possible
    events happen; `CHOICES` returns how many there are.
    """
    fixed, now, faults = t.fixed, t.now, t.faults
    x, y = faults[first * LINE], faults[first * LINE + 1]
    decode(t, x, y)
    shared, may, rows, parent = now[0], 0, 0, first
    kinds, passed = faults[first * LINE + 4], 0
    for w in range(fixed[WATCHED] - 1):
        holding = team_column(t, now[0], G_HOLDING + w)
        for i in range(fixed[AGENTS]):
            if holding >> i & 1:
                if chosen >> may & 1:
                    shared = after_absence(t, shared, i, W_FREED + w)
                    passed |= 1 << i
                    kinds |= 1 << FREED
                    if shared < 0 or not write_event(t, room + rows, parent, FREED | i << E_AGENT, kinds, passed):
                        return -1
                    parent = room + rows
                    rows += 1
                may += 1
    for i in range(fixed[AGENTS]):
        what = absence_change(t, shared, i)
        if what < 0:
            continue
        becomes = ANEW if what == W_BACK and team_column(t, shared, G_MISSED) >> i & 1 else -1
        if what in (W_ANEW, W_MISSED):
            may += 1
            if not chosen >> may - 1 & 1:
                continue
            becomes = ANEW if what == W_ANEW else LOST
            passed |= 1 << i
            kinds |= 1 << MISSED
            if not write_event(t, room + rows, parent, MISSED | i << E_AGENT, kinds, passed):
                return -1
            parent = room + rows
            rows += 1
        shared = after_absence(t, shared, i, what)
        if shared < 0:
            return -1
        if becomes >= 0:
            x, y, is_known = key_after_absence(t, i, becomes, x, y)
            if not is_known:
                return -1
    x ^= (now[0] ^ shared) << t.shift[0]
    t.regs[CHOICES] = may
    if may > MOST_CHOICES or (rows == 0 and not write_event(t, room, -1, 0, kinds, 0)):
        t.regs[CODE] = TOO_MANY
        return -1
    at = (room + max(rows, 1) - 1) * LINE
    faults[at], faults[at + 1] = x, y
    return rows


def absence_change(t: Tables, shared: int, i: int) -> int:
    """The absence event that agent i may have: `W_BACK`, `W_SILENT`, `W_MISSED` or `W_ANEW`; -1 for none."""
    fixed = t.fixed
    if not team_column(t, shared, G_MEMBERS) >> i & 1:
        return -1
    row = (i * fixed[INSIDE_STRIDE] + t.now[1 + i]) * fixed[INSIDE_WIDTH]
    is_up = t.insides[row + I_DOWN] == RUNS
    is_silent = team_column(t, shared, G_SILENT) >> i & 1 == 1
    if is_up and not t.insides[row + I_MUTED]:
        return W_BACK if is_silent else -1
    if not is_silent:
        return W_SILENT
    if not team_column(t, shared, G_PLAYING) >> i & 1:
        return -1
    return W_ANEW if is_up else W_MISSED


def key_after_absence(t: Tables, i: int, becomes: int, x: int, y: int) -> tuple[int, int, bool]:
    """A key after agent i was missed, or begins anew (`becomes`); False if a table lacks an entry."""
    fixed, now = t.fixed, t.now
    inside = t.insides[(i * fixed[INSIDE_STRIDE] + now[1 + i]) * fixed[INSIDE_WIDTH] + I_BEFALLEN + becomes]
    if inside < 0:
        t.regs[CODE], t.regs[MISS_A], t.regs[MISS_B] = MISS_DOWN, i, becomes
        return x, y, False
    x, y = with_field(t, 1 + i, now[1 + i], inside, x, y)
    road = t.agents[i * AGENT + A_ROAD]
    if road >= 0 and becomes == ANEW:
        f = fixed[ROAD_FIELD] + road
        before = (y if t.word[f] else x) >> t.shift[f] & t.mask[f]
        conf = conf_after_fault(t, before, t.agents[i * AGENT + A_PLACE], ANEW)
        if conf < 0:
            return x, y, False
        x, y = with_field(t, f, before, conf, x, y)
    return x, y, True


def write_event(t: Tables, at: int, parent: int, event: int, kinds: int, passed: int) -> bool:
    """Writes an event into a row of `faults`; returns False if there is no room."""
    if (at + 1) * LINE > len(t.faults):
        t.regs[CODE] = TOO_MANY
        return False
    row = at * LINE
    t.faults[row + 2], t.faults[row + 3], t.faults[row + 4], t.faults[row + 5] = event, parent, kinds, passed
    return True
