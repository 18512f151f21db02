"""What two lists have in common, in the same order: long alike stretches first, so that an edit stays local.

Like a patience diff: equal ends are taken off, what occurs once on both sides holds the rest together, small remainders
are worked out exactly, and large ones without anything unique greedily. Everything but the small remainders costs
n log n, so lists of thousands are no burden. Indices are pairs (in the first list, in the second), rising in both.
"""

from __future__ import annotations

from bisect import bisect_left
from collections import Counter
from collections.abc import Hashable, Sequence

Pairs = list[tuple[int, int]]

MOST_EXACT = 4096
"""Cells of the table for a remainder that is worked out exactly."""


def common_order(first: Sequence[Hashable], second: Sequence[Hashable]) -> Pairs:
    """Pairs of indices of equal items."""
    found: Pairs = []
    waiting = [(0, len(first), 0, len(second))]
    while waiting:
        a, a_end, b, b_end = waiting.pop()
        while a < a_end and b < b_end and first[a] == second[b]:
            found.append((a, b))
            a, b = a + 1, b + 1
        while a < a_end and b < b_end and first[a_end - 1] == second[b_end - 1]:
            a_end, b_end = a_end - 1, b_end - 1
            found.append((a_end, b_end))
        if a == a_end or b == b_end:
            continue
        anchors = _anchors(first, second, (a, a_end, b, b_end))
        if anchors:
            found += anchors
            for (i, j), (i_next, j_next) in zip([(a - 1, b - 1), *anchors], [*anchors, (a_end, b_end)], strict=True):
                waiting.append((i + 1, i_next, j + 1, j_next))
        elif (a_end - a) * (b_end - b) <= MOST_EXACT:
            found += [(a + i, b + j) for i, j in _longest(first[a:a_end], second[b:b_end])]
        else:
            found += _greedy(first, second, (a, a_end, b, b_end))
    return sorted(found)


def _anchors(first: Sequence[Hashable], second: Sequence[Hashable], window: tuple[int, int, int, int]) -> Pairs:
    """What occurs once on both sides, as far as it is in the same order."""
    a, a_end, b, b_end = window
    counts, others = Counter(first[a:a_end]), Counter(second[b:b_end])
    place = {first[i]: i for i in range(a, a_end)}
    pairs = [(place[second[j]], j) for j in range(b, b_end) if counts[second[j]] == others[second[j]] == 1]
    return _rising(pairs)


def _rising(pairs: Pairs) -> Pairs:
    """The longest part of pairs (rising in the second index) that rises in the first too."""
    ends: list[int] = []
    at: list[int] = []
    before: list[int | None] = []
    for number, (i, _) in enumerate(pairs):
        length = bisect_left(ends, i)
        before.append(at[length - 1] if length else None)
        if length == len(ends):
            ends.append(i)
            at.append(number)
        else:
            ends[length], at[length] = i, number
    chosen: Pairs = []
    number_or_none = at[-1] if at else None
    while number_or_none is not None:
        chosen.append(pairs[number_or_none])
        number_or_none = before[number_or_none]
    return chosen[::-1]


def _longest(first: Sequence[Hashable], second: Sequence[Hashable]) -> Pairs:
    """A longest common subsequence, by the table of lengths."""
    width = len(second)
    lengths = [[0] * (width + 1) for _ in range(len(first) + 1)]
    for i in range(len(first) - 1, -1, -1):
        for j in range(width - 1, -1, -1):
            same = first[i] == second[j]
            lengths[i][j] = lengths[i + 1][j + 1] + 1 if same else max(lengths[i + 1][j], lengths[i][j + 1])
    found: Pairs = []
    i = j = 0
    while i < len(first) and j < width:
        if first[i] == second[j]:
            found.append((i, j))
            i, j = i + 1, j + 1
        elif lengths[i + 1][j] >= lengths[i][j + 1]:
            i += 1
        else:
            j += 1
    return found


def _greedy(first: Sequence[Hashable], second: Sequence[Hashable], window: tuple[int, int, int, int]) -> Pairs:
    """Each item of the second list with the next equal one of the first."""
    a, a_end, b, b_end = window
    places: dict[Hashable, list[int]] = {}
    for i in range(a, a_end):
        places.setdefault(first[i], []).append(i)
    found: Pairs = []
    # A far jump would leave nothing for the rest.
    reach = max(64, 4 * abs((a_end - a) - (b_end - b)))
    for j in range(b, b_end):
        here = places.get(second[j], [])
        next_place = bisect_left(here, a)
        if next_place < len(here) and here[next_place] - a <= reach:
            a = here[next_place] + 1
            found.append((a - 1, j))
    return found
