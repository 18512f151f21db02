"""Intervals for a share, in how many of all possible runs something holds, and for the difference of two shares."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Literal

from kitrobot.experiments.statistics.interval import USUAL_CONFIDENCE, Interval, check_confidence, check_counts
from kitrobot.experiments.statistics.special_functions import beta_quantile, normal_quantile
from kitrobot.text.sentences import Sentence

ShareMethod = Literal["wilson", "exact"]
_ROUNDING = 1e-7
"""How far logarithms of the same probability may lie apart."""


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


def share_difference(first: Sequence[float], second: Sequence[float], confidence: float = USUAL_CONFIDENCE) -> Interval:
    """The interval for how much larger the second share is than the first, of runs that are independent.

    Newcombe's hybrid of two score intervals (1998, method 10).

    Args:
        first: 1 for each run in which it holds, 0 for each other one.
        second: the same of other runs.
        confidence: the share (0…1) of intervals that hold the difference.

    Raises:
        StatisticsError: there is no run of one of them.

    Examples:
        >>> found = share_difference([0] * 32 + [1] * 48, [0] * 14 + [1] * 56)
        >>> round(found.low, 4), round(found.high, 4)
        (0.0524, 0.3339)
    """
    one, other = (share_interval(int(sum(runs)), len(runs), confidence) for runs in (first, second))
    difference = other.estimate - one.estimate
    low = difference - math.hypot(other.estimate - other.low, one.high - one.estimate)
    high = difference + math.hypot(other.high - other.estimate, one.estimate - one.low)
    return Interval(difference, low, high, confidence, Sentence("Newcombe's score interval"))


def share_test(first: Sequence[float], second: Sequence[float]) -> float:
    """How probable it is, if both shares are alike, that the runs are split so or less probably: the p-value of
    Fisher's exact test (two-sided).

    Args:
        first: as of `share_difference`.
        second: as of `share_difference`.

    Raises:
        StatisticsError: as `share_difference`.
    """
    ours, runs = check_counts(int(sum(first)), len(first))
    theirs, others = check_counts(int(sum(second)), len(second))
    successes = ours + theirs
    logs = [
        -sum(map(_log_factorial, (one, runs - one, successes - one, others - successes + one)))
        for one in range(max(0, successes - others), min(runs, successes) + 1)
    ]
    here = logs[ours - max(0, successes - others)] + _ROUNDING
    largest = max(logs)
    weights = [math.exp(one - largest) for one in logs]
    return min(1.0, math.fsum(w for w, one in zip(weights, logs, strict=True) if one <= here) / math.fsum(weights))


def _log_factorial(number: int) -> float:
    return math.lgamma(number + 1)


def clopper_pearson(successes: int, runs: int, tail: float) -> tuple[float, float]:
    """The ends of the exact interval that misses a share on either side at most so often (0 < tail < 0.5)."""
    failures = runs - successes
    low = beta_quantile(tail, successes, failures + 1) if successes else 0.0
    high = 1 - beta_quantile(tail, failures, successes + 1) if failures else 1.0
    return low, high
