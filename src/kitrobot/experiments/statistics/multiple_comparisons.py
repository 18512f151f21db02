"""Many comparisons at once: p-values that stay honest."""

from __future__ import annotations

from collections.abc import Iterable

from kitrobot.experiments.statistics.interval import StatisticsError, check_values
from kitrobot.text.sentences import Sentence


def holm(p_values: Iterable[float]) -> list[float]:
    """The p-values adjusted for their number, in the order given (Holm 1979).

    Where all comparisons are without a difference, one adjusted value is below 0.05 with a probability of at most 0.05,
    however the comparisons depend on each other.

    Raises:
        StatisticsError: there is none, or one is not from 0 to 1.

    Examples:
        >>> holm([0.01, 0.04, 0.03])
        [0.03, 0.06, 0.06]
    """
    found = check_values(p_values, 1)
    for place, value in enumerate(found, 1):
        if not 0 <= value <= 1:
            raise StatisticsError(
                Sentence("p-value {place} is {found}", place, f"{value:g}"),
                Sentence("a p-value is a probability, from 0 to 1"),
            )
    adjusted = [0.0] * len(found)
    largest = 0.0
    for rank, place in enumerate(sorted(range(len(found)), key=found.__getitem__)):
        largest = max(largest, min(1.0, found[place] * (len(found) - rank)))
        adjusted[place] = largest
    return adjusted
