"""Long tests come first in the share of each of pytest's workers."""

from __future__ import annotations

import pytest

from tests.shares import in_shares


@pytest.mark.parametrize(
    ("long", "short", "workers"), [(5, 12, 4), (8, 0, 3), (0, 7, 2), (1, 1, 4), (9, 2, 4), (0, 0, 2)]
)
def test_each_share_begins_with_its_part_of_the_long_tests_and_none_is_lost(
    long: int, short: int, workers: int
) -> None:
    longs, shorts = [("long", n) for n in range(long)], [("short", n) for n in range(short)]
    ordered = in_shares(longs, shorts, workers)
    assert [one for one in ordered if one[0] == "long"] == longs
    assert [one for one in ordered if one[0] == "short"] == shorts
    parts, rest = [], ordered
    for left in range(workers, 0, -1):  # as pytest-xdist shares them out
        share, rest = rest[: len(rest) // left], rest[len(rest) // left :]
        kinds = [kind for kind, _ in share]
        assert kinds == sorted(kinds)
        parts.append(kinds.count("long"))
    assert max(parts) - min(parts) <= 1
