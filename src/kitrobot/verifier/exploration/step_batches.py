"""Breadth-first search in batches, for several workers and for searches that keep no states.

A batch is a range of states. Workers *gather* the steps out of their shares of it beside each other. Then each one
*inserts* the states after all these steps that fall into its part of the table, and nobody else touches that part. Then
the new ones are *numbered* in the order of the steps. So nothing is locked, and numbers, parents and steps are those
of `breadth_first_search.visit`, which handles one state after another.

This module uses only the subset of Python that Numba compiles; pause codes mean the same as in `columns`.
"""

from __future__ import annotations

from kitrobot.verifier.exploration.breadth_first_search import CALM, advance, expand, key_hash, note_kinds
from kitrobot.verifier.exploration.state_filter import layout_free_hash
from kitrobot.verifier.tables.columns import (
    AT,
    BASE,
    BATCH_FIRST,
    CALMS,
    CODE,
    COUNT,
    EDGES,
    GATHERED,
    GATHERS,
    GOES_ON,
    KEEPS,
    ROOM_STEPS,
    SEEN_KINDS,
    STEP_ROOM,
    WORDS,
)
from kitrobot.verifier.tables.tables import Graph, StepBatch, Tables

NEW = -1
"""The target of a step to a state that was reached by no step before it; one below it and further down, of a step to
the state that this one of the batch reaches, counted from -2 on."""
LATER = -(1 << 40)
"""The target of a step whose state may belong to the next part of the table."""
_WINDOW = 64
"""Steps whose places in memory are read at once, before they are looked at one after another."""


def explore_states(t: Tables, g: Graph, b: StepBatch, until: int) -> int:
    """Goes on exploring up to the state of this number, or only gathers the steps; why it ended, or GOES_ON.

    It is one function, so that what it calls is compiled once.
    """
    return gather_steps(t, g, b, until) if t.regs[GATHERS] else advance(t, g, until)


def gather_steps(t: Tables, g: Graph, b: StepBatch, until: int) -> int:
    """Writes the steps out of the states up to this number into a worker's region; why it ended, or GOES_ON."""
    regs = t.regs
    two, base, first, is_layout_free = regs[WORDS] == 2, regs[BASE], regs[BATCH_FIRST], len(b.sums) > 0
    at, count = regs[AT], regs[GATHERED]
    while at < until:
        x, y = g.x[at - base], g.y[at - base] if two else 0
        steps = expand(t, x, y)
        if steps < 0:
            return regs[CODE]
        if count + steps > regs[STEP_ROOM]:
            return ROOM_STEPS
        came, is_dead = 0, True
        for n in range(steps):
            nx, ny = t.next_x[n], t.next_y[n]
            came |= t.next_kinds[n]
            if nx != x or ny != y:
                is_dead = False
            b.x[count], b.y[count], b.taken[count] = nx, ny, t.next_taken[n]
            b.places[count] = layout_free_hash(b.sums, nx, ny, two) if is_layout_free else key_hash(nx, ny)
            count += 1
        if came & ~regs[SEEN_KINDS]:
            note_kinds(t, at, came)
        b.ends[at - first] = count
        b.calm[at - first] = 2 if is_dead else 1 if came & ~CALM == 0 else 0
        at += 1
        regs[AT], regs[GATHERED] = at, count
    return GOES_ON


def insert_steps(g: Graph, b: StepBatch, first: int, end: int, low: int, high: int, two: bool) -> int:
    """Looks up the states after these steps whose places are from `low` to before `high`, and inserts new ones.

    A new one is a negative number in the table until it is numbered. What is returned has no meaning: it keeps compilers
    from leaving out reads.
    """
    slots, known, other = g.slots, g.x, g.y
    last = len(slots) - 1
    is_alone = low == 0 and high > last
    mixed = 0
    for at in range(first, end, _WINDOW):
        until = min(at + _WINDOW, end)
        # As in `breadth_first_search.touch`.
        for n in range(at, until):
            place = b.places[n] & last
            if low <= place and place < high:
                mixed ^= slots[place]
        for n in range(at, until):
            place = b.places[n] & last
            if low <= place and place < high and slots[place] > 0:
                mixed ^= known[slots[place] - 1]
        for n in range(at, until):
            place = b.places[n] & last
            if place < low or place >= high:
                continue
            x, y = b.x[n], b.y[n]
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
        if is_same(g, b, g.slots[place], b.x[n], b.y[n], two):
            return g.slots[place] - 1
        place = place + 1 & last
    b.places[n] = place
    return NEW


def number_steps(t: Tables, g: Graph, b: StepBatch, until: int, first: int) -> int:
    """Numbers the new states after the steps out of the states up to this one; the first of these steps is `first`."""
    regs, keeps, two = t.regs, t.regs[KEEPS], t.regs[WORDS] == 2
    at, count, edges, n = regs[AT], regs[COUNT], regs[EDGES], first
    begin = regs[BATCH_FIRST]
    while at < until:
        end = b.ends[at - begin]
        while n < end:
            number = b.targets[n]
            if number == LATER:
                number = find_place(g, b, n, two)
            if number < NEW:
                number = b.targets[-2 - number]
            elif number == NEW:
                number = count
                g.slots[b.places[n]] = count + 1
                g.x[count], g.parents[count] = b.x[n], at
                if two:
                    g.y[count] = b.y[n]
                count += 1
            b.targets[n] = number
            if keeps:
                g.targets[edges], g.taken[edges] = number, b.taken[n]
                edges += 1
            n += 1
        if keeps:
            g.first_edge[at + 1] = edges
        if b.calm[at - begin]:
            g.calm[regs[CALMS]] = at
            regs[CALMS] += 1
        at += 1
    regs[AT], regs[COUNT], regs[EDGES] = at, count, edges
    return GOES_ON
