"""The tables of a model and the explored graph: lists under CPython, arrays under Numba (see `columns`)."""

from __future__ import annotations

from collections.abc import MutableSequence
from typing import NamedTuple

Row = MutableSequence[int]
"""Whole numbers: a list, or an array."""


class Tables(NamedTuple):
    """The tables of a model, filled on demand during the exploration.

    Attributes:
        regs, fixed: numbers that change while exploring, and that do not.
        shift, mask, word: of each field where it is in a key: the word, how far up, and its bits.
        agents, geo, visits, acts, road_agents: the mission, its roads and devices.
        insides: of each agent `INSIDE_STRIDE` rows.
        shared: a row for each number of what is shared.
        change_keys, change_to: (number, write) → number after it, by open addressing; a key of -1 is free.
        reaction_keys, reaction_at: (see `S_SHARED`) → its first row in `outcomes` and how many (see `S_COUNT`).
        outcomes: what ticks bring.
        confs, conf_slots: motions on roads, and where to find them by their bodies (number + 1; 0 is free).
        moves, move_sets, log: what can follow each.
        taken, taken_slots: sets of progress classes that steps belong to, by number (see `TAKEN_WIDTH`).
        made: the bodies of a road that are being put together.
        now, seen: the fields of the state that is looked at; the reactions of its agents.
        pool, pool_slots, given_slots: what `traffic.fill_move_sets` looks through.
        line, faults: states between two ticks of lockstep: after completed actions, and after faults.
        after_heads, after_slots, after: what may follow in lockstep once robots moved (see `lockstep_ticks`).
        next_x, next_y, next_taken, next_kinds, next_slots: the steps out of a state: keys, progress, kinds of events.
        next_event: of steps that are one event that event.
        events: the events of the step that is sought.
    """

    regs: Row
    fixed: Row
    shift: Row
    mask: Row
    word: Row
    agents: Row
    geo: Row
    visits: Row
    acts: Row
    road_agents: Row
    insides: Row
    shared: Row
    change_keys: Row
    change_to: Row
    reaction_keys: Row
    reaction_at: Row
    outcomes: Row
    confs: Row
    conf_slots: Row
    moves: Row
    move_sets: Row
    log: Row
    taken: Row
    taken_slots: Row
    made: Row
    now: Row
    seen: Row
    pool: Row
    pool_slots: Row
    given_slots: Row
    line: Row
    faults: Row
    after_heads: Row
    after_slots: Row
    after: Row
    next_x: Row
    next_y: Row
    next_taken: Row
    next_kinds: Row
    next_slots: Row
    next_event: Row
    events: Row


class Graph(NamedTuple):
    """The states that were reached, in the order of their distance from the first.

    Attributes:
        x, y: their keys; `y` is as long only where there are two words.
        parents: of each the state from which it was reached first; -1 of the first.
        slots: open addressing: number + 1; 0 is free.
        first_edge: the steps out of state n, if steps are stored, are `first_edge[n]` … `first_edge[n + 1]` - 1. Ticks
            that change nothing are stored only in lockstep.
        targets, taken: the state after each step, and its progress classes, by number.
        calm: states that no step leaves, or only steps of kinds that may mean nothing (`breadth_first_search.CALM`).
    """

    x: Row
    y: Row
    parents: Row
    slots: Row
    first_edge: Row
    targets: Row
    taken: Row
    calm: Row


class StepBatch(NamedTuple):
    """The steps out of states that follow each other, and what they come to (see `exploration.step_batches`).

    Each worker has a region of the same length for its steps.

    Attributes:
        x, y: the key after each step.
        places: its hash; of a new state then its place in the table.
        targets: the number of the state after each step, or what is known of it.
        taken: the progress classes of each step, by number.
        begins, ends: of each state its first step and the end of its steps; an end of -1 where a worker left it out.
        kinds: of each state the kinds of the events of its steps.
        calm: whether a state is calm (see `Graph.calm`): 2 if no step leaves it.
        own: of each worker the steps that are its own among some that follow each other.
        sums: for each byte of a key 256 words, whose sums without carry are hashes that no layout changes; empty where
            hashes are those of keys.
    """

    x: Row
    y: Row
    places: Row
    targets: Row
    taken: Row
    begins: Row
    ends: Row
    kinds: Row
    calm: Row
    own: Row
    sums: Row


class StateFilter(NamedTuple):
    """What an approximate search keeps of the states that it reached (see `exploration.state_filter`).

    Attributes:
        bits: a Bloom filter in blocks of 64 bytes.
        births: of each state how many states were reached from it first, 255 for that many or more.
        picks: of each state the place of the step that reached it first, among those of its state, modulo 256.
        wide: of states with 255 births or more the number and how many, one after another.
        counts: how many numbers of `wide` are used.
    """

    bits: Row
    births: Row
    picks: Row
    wide: Row
    counts: Row


def find(keys: Row, key: int) -> int:
    """Where a key is in a table of open addressing, or the free place where it is missing."""
    last = len(keys) - 1
    at = (key * 0x1E3779B97F4A7C15 & 0x7FFFFFFFFFFFFFFF) >> 31 & last
    while keys[at] != key and keys[at] >= 0:
        at = at + 1 & last
    return at
