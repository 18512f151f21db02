"""Conditions on states: evaluated for all states at once from the truth of each component, and followed along steps."""

from __future__ import annotations

from kitrobot.verifier.tables.state_decoding import decode, sense_key
from kitrobot.verifier.tables.tables import Graph, Row, Tables

FACT = 3
"""A row of `facts`: the number of its clause, a field, where its truth begins in `truths`, by the field's number."""


def mark_states(t: Tables, g: Graph, first: int, end: int, two: bool, facts: Row, truths: Row, marks: Row) -> int:
    """Marks those of the states from `first` to before `end` for which all facts of one clause hold; how many."""
    count = 0
    rows = len(facts) // FACT
    for number in range(first, end):
        x, y = g.x[number], g.y[number] if two else 0
        n, holds = 0, False
        while n < rows and not holds:
            clause, holds = facts[n * FACT], True
            while n < rows and facts[n * FACT] == clause:
                f = facts[n * FACT + 1]
                value = (y if t.word[f] else x) >> t.shift[f] & t.mask[f]
                holds = holds and truths[facts[n * FACT + 2] + value] != 0
                n += 1
        marks[number] = 1 if holds else 0
        count += 1 if holds else 0
    return count


def sense_agent(t: Tables, g: Graph, first: int, end: int, two: bool, i: int, keys: Row) -> int:
    """Writes for each of the states from `first` to before `end` what agent i senses and is (`sense_key`); how many."""
    for number in range(first, end):
        decode(t, g.x[number], g.y[number] if two else 0)
        keys[number - first] = sense_key(t, i)
    return end - first


def find_crossing(g: Graph, first: int, end: int, before: Row, after: Row) -> int:
    """Of the states from `first` to before `end`, which have all their steps, the first one marked `before` out of
    which a step leads into one marked `after`; -1 for none.
    """
    for state in range(first, end):
        if before[state]:
            for e in range(g.first_edge[state], g.first_edge[state + 1]):
                if after[g.targets[e]]:
                    return state
    return -1


def prune_open_states(g: Graph, states: Row, count: int, marks: Row, inside: Row) -> int:
    """Of so many states those that are marked and that no step leads out of into another one than these, or nearly: it
    is to be called until it leaves as many as before. They stay in `states`, in order; how many are left.

    States are in the order in which they were reached, and looked at from the last one on: most steps lead onwards.
    `inside` has no marks before the first call.
    """
    for n in range(count):
        inside[states[n]] = marks[states[n]]
    for n in range(count - 1, -1, -1):
        state = states[n]
        e, end = g.first_edge[state], g.first_edge[state + 1]
        while inside[state] and e < end:
            if not inside[g.targets[e]]:
                inside[state] = 0
            e += 1
    left = 0
    for n in range(count):
        if inside[states[n]]:
            states[left] = states[n]
            left += 1
    return left
