"""Breadth-first search in batches, for several workers and for searches that keep no states.

A batch is a range of states. Workers *gather* the steps out of their shares of it beside each other. Then each one
*inserts* the states after all these steps that fall into its part of the table, and nobody else touches that part. Then
the new ones are *numbered* in the order of the steps. So nothing is locked, and numbers, parents and steps are those
of `breadth_first_search.visit`, which handles one state after another.

This module uses only the subset of Python that Numba compiles; pause codes mean the same as in `columns`.
"""

from __future__ import annotations

from kitrobot.verifier.exploration.breadth_first_search import CALM, advance, expand, key_hash, note_kinds
from kitrobot.verifier.tables.columns import (
    ALL_BITS,
    AT,
    BASE,
    BATCH_FIRST,
    CALMS,
    CODE,
    COUNT,
    EDGES,
    GATHER_AT,
    GATHERED,
    GATHERS,
    GATHERS_LEFT_OUT,
    GOES_ON,
    IS_WORKER,
    KEEPS,
    LEFT_OUT,
    MULTIPLIER,
    ROOM_STEPS,
    SEEN_KINDS,
    STEP_ROOM,
    WORDS,
)
from kitrobot.verifier.tables.tables import Graph, Row, StepBatch, Tables

NEW = -1
"""The target of a step to a state that was reached by no step before it; one below it and further down, of a step to
the state that this one of the batch leads to, counted from -2 on."""
LATER = -(1 << 40)
"""The target of a step whose state may belong to the next part of the table."""
WINDOW = 64
"""Steps whose places in memory are read at once, before they are looked at one after another."""


def explore_states(t: Tables, g: Graph, b: StepBatch, until: int) -> int:
    """Goes on exploring up to the state of this number, or only gathers the steps; why it ended, or GOES_ON.

    It is one function, so that what it calls is compiled once.
    """
    return gather_steps(t, g, b, until) if t.regs[GATHERS] else advance(t, g, until)


def gather_steps(t: Tables, g: Graph, b: StepBatch, until: int) -> int:
    """Writes the steps out of the states up to this number into a worker's region; why it ended, or GOES_ON.

    A worker leaves out a state whose steps need entries that it may not add. The owner of the tables gathers those.
    """
    regs = t.regs
    two, keeps, base, first = regs[WORDS] == 2, regs[KEEPS], regs[BASE], regs[BATCH_FIRST]
    is_worker, is_layout_free = regs[IS_WORKER], len(b.sums) > 0
    only_left_out = regs[GATHERS] == GATHERS_LEFT_OUT
    at, count = regs[GATHER_AT], regs[GATHERED]
    while at < until:
        if only_left_out and b.ends[at - first] >= 0:
            at += 1
            continue
        x, y = g.x[at - base], g.y[at - base] if two else 0
        steps = expand(t, x, y)
        if steps < 0:
            if is_worker:
                b.ends[at - first] = -1
                regs[LEFT_OUT] += 1
                at += 1
                continue
            regs[GATHER_AT], regs[GATHERED] = at, count
            return regs[CODE]
        if count + steps > regs[STEP_ROOM]:
            return ROOM_STEPS
        b.begins[at - first] = count
        came, is_dead = 0, True
        for n in range(steps):
            nx, ny = t.next_x[n], t.next_y[n]
            came |= t.next_kinds[n]
            if nx != x or (two and ny != y):
                is_dead = False
            b.x[count] = nx
            if two:
                b.y[count] = ny
            if keeps:
                b.taken[count] = t.next_taken[n]
            b.places[count] = layout_free_hash(b.sums, nx, ny, two) if is_layout_free else key_hash(nx, ny)
            count += 1
        b.ends[at - first], b.kinds[at - first] = count, came
        b.calm[at - first] = 2 if is_dead else 1 if came & ~CALM == 0 else 0
        at += 1
    regs[GATHER_AT], regs[GATHERED] = at, count
    return GOES_ON


def layout_free_hash(sums: Row, x: int, y: int, two: bool) -> int:
    """A hash of a key that stays the same when fields widen: of each bit of each field a random word, summed without
    carry, then mixed.
    """
    h = 0
    for k in range(8):
        h ^= sums[256 * k + (x >> 8 * k & 255)]
    if two:
        for k in range(8):
            h ^= sums[2048 + 256 * k + (y >> 8 * k & 255)]
    return ((h ^ h >> 29) * MULTIPLIER) & ALL_BITS


def insert_steps(g: Graph, b: StepBatch, first: int, end: int, low: int, high: int, own: int, two: bool) -> int:
    """Looks up the states after these steps whose places are from `low` to before `high`, and inserts new ones.

    A new one is a negative number in the table until it is numbered. `own`: where the worker's part of `b.own` begins.
    What is returned has no meaning: it keeps compilers from leaving out reads.
    """
    slots, known = g.slots, g.x
    last = len(slots) - 1
    is_alone = low == 0 and high > last
    mixed = 0
    for at in range(first, end, WINDOW):
        count = own
        # No branches: which steps are a worker's own is as good as chance.
        for n in range(at, min(at + WINDOW, end)):
            place = b.places[n] & last
            b.own[count] = n
            count += (place >= low) & (place < high)
        # As in `breadth_first_search.touch`.
        for k in range(own, count):
            mixed ^= slots[b.places[b.own[k]] & last]
        for k in range(own, count):
            number = slots[b.places[b.own[k]] & last]
            if number > 0:
                mixed ^= known[number - 1]
        for k in range(own, count):
            n = b.own[k]
            place = b.places[n] & last
            x, y = b.x[n], b.y[n] if two else 0
            while True:
                number = slots[place]
                if number == 0:
                    slots[place] = -n - 1
                    b.places[n], b.targets[n] = place, NEW
                    break
                if is_same(g, b, number, x, y, two):
                    b.targets[n] = number - 1
                    break
                place += 1
                if place == high:
                    if not is_alone:
                        b.targets[n] = LATER
                        break
                    place = 0
    return mixed


def is_same(g: Graph, b: StepBatch, number: int, x: int, y: int, two: bool) -> bool:
    """Whether a number in the table is of this key: of a state, plus 1, or negative of a step in the batch."""
    if number > 0:
        return g.x[number - 1] == x and (not two or g.y[number - 1] == y)
    return b.x[-number - 1] == x and (not two or b.y[-number - 1] == y)


def find_place(g: Graph, b: StepBatch, n: int, two: bool) -> int:
    """The target of a step that was left for later; a free place for it is found if it is new."""
    last = len(g.slots) - 1
    place = b.places[n] & last
    while g.slots[place] != 0:
        if is_same(g, b, g.slots[place], b.x[n], b.y[n] if two else 0, two):
            return g.slots[place] - 1
        place = place + 1 & last
    b.places[n] = place
    return NEW


def number_steps(t: Tables, g: Graph, b: StepBatch, until: int) -> int:
    """Numbers the new states after the steps out of the states up to this one, in the order of the states."""
    regs, keeps, two = t.regs, t.regs[KEEPS], t.regs[WORDS] == 2
    at, count, edges, first = regs[AT], regs[COUNT], regs[EDGES], regs[BATCH_FIRST]
    while at < until:
        for n in range(b.begins[at - first], b.ends[at - first]):
            number, new = b.targets[n], n
            if number == LATER:
                number = find_place(g, b, n, two)
            if number < NEW:
                # The worker met another step to that state first, perhaps one that comes later.
                new = -2 - number
                number = b.targets[new]
            if number == NEW:
                number = count
                g.slots[b.places[new]] = count + 1
                g.x[count], g.parents[count] = b.x[n], at
                if two:
                    g.y[count] = b.y[n]
                b.targets[new] = count
                count += 1
            if keeps:
                g.targets[edges], g.taken[edges] = number, b.taken[n]
                edges += 1
        if keeps:
            g.first_edge[at + 1] = edges
        note_state(t, g, b, at, at)
        at += 1
    regs[AT], regs[COUNT], regs[EDGES] = at, count, edges
    return GOES_ON


def note_state(t: Tables, g: Graph, b: StepBatch, at: int, calm: int) -> None:
    """Notes the first events of their kinds out of a state of the batch, and, if it is calm, this number of it."""
    regs, place = t.regs, at - t.regs[BATCH_FIRST]
    if b.kinds[place] & ~regs[SEEN_KINDS]:
        note_kinds(t, at, b.kinds[place])
    if b.calm[place]:
        g.calm[regs[CALMS]] = calm
        regs[CALMS] += 1
