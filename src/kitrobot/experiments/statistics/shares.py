"""Intervals for a share: in how many of all possible runs something holds."""

from __future__ import annotations

import math
from typing import Literal

from kitrobot.experiments.statistics.interval import USUAL_CONFIDENCE, Interval, check_confidence, check_counts
from kitrobot.experiments.statistics.special_functions import beta_quantile, normal_quantile
from kitrobot.text.sentences import Sentence

ShareMethod = Literal["wilson", "exact"]


def share_interval(
    successes: int, runs: int, confidence: float = USUAL_CONFIDENCE, method: ShareMethod = "wilson"
) -> Interval:
    """The interval for a share of which so many of so many independent runs are known.

    Args:
        successes: in how many runs it holds.
        runs: how many there are; their number is chosen before they are looked at.
        confidence: the share (0…1) of intervals that hold the truth.
        method: "wilson" (Wilson 1927) holds it about so often, "exact" (Clopper and Pearson 1934) at least so often,
            whatever the share, and is wider.

    Raises:
        StatisticsError: a number makes no sense.

    Examples:
        >>> found = share_interval(9, 10, 0.95, "exact")
        >>> round(found.low, 4), round(found.high, 4)
        (0.555, 0.9975)
    """
    check_confidence(confidence)
    successes, runs = check_counts(successes, runs)
    estimate = successes / runs
    if method == "wilson":
        low, high = _wilson(successes, runs, confidence)
        words = Sentence("Wilson's score interval")
    else:
        low, high = clopper_pearson(successes, runs, (1 - confidence) / 2)
        words = Sentence("Clopper and Pearson's exact interval")
    return Interval(estimate, min(low, estimate), max(high, estimate), confidence, words)


def _wilson(successes: int, runs: int, confidence: float) -> tuple[float, float]:
    squared = normal_quantile((1 + confidence) / 2) ** 2
    middle = (successes + squared / 2) / (runs + squared)
    spread = math.sqrt(squared * (successes * (runs - successes) / runs + squared / 4)) / (runs + squared)
    low = middle - spread if successes else 0.0
    return low, middle + spread if successes < runs else 1.0


def clopper_pearson(successes: int, runs: int, tail: float) -> tuple[float, float]:
    """The ends of the exact interval that misses a share on either side at most so often (0 < tail < 0.5)."""
    failures = runs - successes
    low = beta_quantile(tail, successes, failures + 1) if successes else 0.0
    high = 1 - beta_quantile(tail, failures, successes + 1) if failures else 1.0
    return low, high
