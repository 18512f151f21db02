"""The seeds of a study: whole numbers and ranges of them, such as `1-1000,2000`."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from itertools import accumulate, pairwise

from kitrobot.experiments.addresses import ExperimentError
from kitrobot.sim.setup.limits import MAX_SEED
from kitrobot.text.sentences import Sentence

_RANGE = re.compile(r"(\d{1,16})(?:(?:-|\.\.)(\d{1,16}))?")


@dataclass(frozen=True)
class Seeds:
    """Seeds in their order, as ranges."""

    ranges: tuple[range, ...]

    @cached_property
    def _ends(self) -> list[int]:
        return list(accumulate(len(one) for one in self.ranges))

    def __len__(self) -> int:
        return self._ends[-1]

    def __getitem__(self, number: int) -> int:
        at = bisect_right(self._ends, number)
        return self.ranges[at][number - (self._ends[at - 1] if at else 0)]

    @property
    def text(self) -> str:
        """As `read_seeds` reads them."""
        return ",".join(f"{one[0]}-{one[-1]}" if len(one) > 1 else str(one[0]) for one in self.ranges)


def read_seeds(text: str) -> Seeds:
    """Seeds from their text.

    Raises:
        ExperimentError: it is none, one is too large, or one is there twice.
    """
    found = [_RANGE.fullmatch(part.strip()) for part in text.split(",")]
    ranges = tuple(range(int(one[1]), int(one[2] or one[1]) + 1) for one in found if one is not None)
    if None in found or not all(ranges) or max(one[-1] for one in ranges) > MAX_SEED:
        message = Sentence("expected seeds such as 1-1000 or 1,2,5, from 0 to {most}, found `{found}`", MAX_SEED, text)
        raise ExperimentError(message)
    inside = sorted(ranges, key=lambda one: one[0])
    if any(one[-1] >= other[0] for one, other in pairwise(inside)):
        raise ExperimentError(Sentence("a seed is twice among `{seeds}`", text))
    return Seeds(ranges)


def seeds_of(numbers: Iterable[int]) -> Seeds:
    """Seeds from whole numbers; neighbours become ranges.

    Raises:
        ExperimentError: there are none, one is too large, or one is there twice.
    """
    ends: list[list[int]] = []
    for number in numbers:
        if ends and number == ends[-1][1] + 1:
            ends[-1][1] = number
        else:
            ends.append([number, number])
    return read_seeds(",".join(f"{first}-{last}" for first, last in ends))
