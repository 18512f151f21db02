"""Breadth-first search: the set of visited states, with open addressing over keys.

This module uses only the subset of Python that Numba compiles. If a table has no room, or lacks an entry, a call ends
with a number that says so (see `columns`); the caller fixes that, and the search continues with the same state.
"""

from __future__ import annotations

from kitrobot.verifier.tables.columns import (
    ALL_BITS,
    AT,
    CALMS,
    CODE,
    COUNT,
    CUT,
    DEPTH,
    EDGES,
    FIRST_OF,
    GOES_ON,
    KEEPS,
    KINDS,
    LEVEL_END,
    LOCKSTEP,
    MOST,
    MULTIPLIER,
    OTHER_MULTIPLIER,
    ROOM_CALM,
    ROOM_EDGES,
    ROOM_STATES,
    SEEN_KINDS,
    TIMING,
    TOUCHED,
    WORDS,
)
from kitrobot.verifier.tables.events import TICK
from kitrobot.verifier.tables.motion import BEGIN, HALT
from kitrobot.verifier.tables.tables import Graph, Row, Tables
from kitrobot.verifier.transitions.interleaved_successors import expand_interleaved
from kitrobot.verifier.transitions.lockstep_successors import expand_lockstep

CALM = 1 << TICK | 1 << BEGIN | 1 << HALT
"""Kinds of events that may come for ever while nothing happens: at the end of an open road a robot that is told to go
on begins to roll and stands, and gets nowhere.
"""
FAR = 4_000_000
"""States from which on waiting for memory takes longer than asking for it twice."""


def expand(t: Tables, x: int, y: int) -> int:
    """Puts the steps out of a state into `next_x` and its neighbours; how many, or -1."""
    return expand_lockstep(t, x, y) if t.fixed[TIMING] == LOCKSTEP else expand_interleaved(t, x, y)


def advance(t: Tables, g: Graph, until: int) -> int:
    """Goes on exploring up to the state of this number; why it ended, or GOES_ON."""
    regs = t.regs
    two = regs[WORDS] == 2
    at = regs[AT]
    while at < regs[COUNT] and at < until:
        if at == regs[LEVEL_END]:
            regs[DEPTH] += 1
            regs[LEVEL_END] = regs[COUNT]
        steps = expand(t, g.x[at], g.y[at] if two else 0)
        code = visit(t, g, at, steps, two) if steps >= 0 else regs[CODE]
        if code != GOES_ON:
            return code
        at += 1
        regs[AT] = at
    return GOES_ON


def visit(t: Tables, g: Graph, at: int, steps: int, two: bool) -> int:
    """Adds the steps out of a state to what was reached."""
    regs, slots, known, other = t.regs, g.slots, g.x, g.y
    count, edges, keeps = regs[COUNT], regs[EDGES], regs[KEEPS]
    most = min(count + steps, regs[MOST])
    last = len(slots) - 1
    if most > len(known) or (count + steps) * 10 > len(slots) * 7:
        return ROOM_STATES
    if keeps and (edges + steps > len(g.targets) or at + 2 > len(g.first_edge)):
        return ROOM_EDGES
    if regs[CALMS] >= len(g.calm):
        return ROOM_CALM
    if count > FAR:
        touch(t, g, steps)
    seen, came, is_dead = regs[SEEN_KINDS], 0, True
    for n in range(steps):
        x, y, kinds = t.next_x[n], t.next_y[n], t.next_kinds[n]
        came |= kinds
        if kinds & ~seen:
            seen = note_kinds(t, at, kinds)
        place = key_hash(x, y) & last
        number = slots[place] - 1
        while number >= 0 and (known[number] != x or (two and other[number] != y)):
            place = place + 1 & last
            number = slots[place] - 1
        if number < 0:
            if count >= regs[MOST]:
                regs[COUNT] = count
                return CUT
            number = count
            slots[place] = count + 1
            known[count] = x
            if two:
                other[count] = y
            g.parents[count] = at
            count += 1
        if number != at:
            is_dead = False
        if keeps:
            g.targets[edges] = number
            g.taken[edges] = t.next_taken[n]
            edges += 1
    if keeps:
        g.first_edge[at + 1] = edges
        regs[EDGES] = edges
    if is_dead or came & ~CALM == 0:
        g.calm[regs[CALMS]] = at
        regs[CALMS] += 1
    regs[COUNT] = count
    return GOES_ON


def note_kinds(t: Tables, at: int, kinds: int) -> int:
    """Notes a state as the first one with the new ones among these kinds of events; all that have been seen."""
    seen = t.regs[SEEN_KINDS]
    for kind in range(KINDS):
        if kinds & ~seen & 1 << kind:
            t.regs[FIRST_OF + kind] = at
    t.regs[SEEN_KINDS] = seen | kinds
    return seen | kinds


def touch(t: Tables, g: Graph, steps: int) -> None:
    """Reads what `visit` will, all steps at once: what lies far apart in memory then comes while other reads wait for
    theirs, instead of one after another.
    """
    slots, known, last = g.slots, g.x, len(g.slots) - 1
    mixed = 0
    for n in range(steps):
        mixed ^= slots[key_hash(t.next_x[n], t.next_y[n]) & last]
    for n in range(steps):
        number = slots[key_hash(t.next_x[n], t.next_y[n]) & last] - 1
        if number >= 0:
            mixed ^= known[number]
    # Kept, so that no compiler leaves the reading out.
    t.regs[TOUCHED] = mixed


def key_hash(x: int, y: int) -> int:
    """Where to look for a key."""
    h = ((x ^ x >> 29) * MULTIPLIER ^ y * OTHER_MULTIPLIER) & ALL_BITS
    return h >> 30


def rehash(g: Graph, count: int, two: bool) -> None:
    """Fills the slots, which are all free, with so many states."""
    slots = g.slots
    last = len(slots) - 1
    for number in range(count):
        place = key_hash(g.x[number], g.y[number] if two else 0) & last
        while slots[place] != 0:
            place = place + 1 & last
        slots[place] = number + 1


def repack(g: Graph, count: int, fields: int, old: Row, new: Row, was_two: bool, is_two: bool) -> None:
    """Writes the keys of so many states anew; `old` and `new` hold word, shift and mask of each field."""
    for number in range(count):
        x, y = g.x[number], g.y[number] if was_two else 0
        nx = ny = 0
        for f in range(fields):
            value = (y if old[3 * f] else x) >> old[3 * f + 1] & old[3 * f + 2]
            if new[3 * f]:
                ny |= value << new[3 * f + 1]
            else:
                nx |= value << new[3 * f + 1]
        g.x[number] = nx
        if is_two:
            g.y[number] = ny
