"""When runs are enough: a share that is known to a precision, without a broken promise because one stopped early.

Whoever looks at an interval after each run and stops when it is narrow has intervals that miss the truth too often.
Here the *looks* are planned before the first run: the last one at a number of runs that is enough for every share, and
earlier ones each 1.4 times as many as the one before. Each is an exact interval (Clopper and Pearson 1934) of its
first runs. Of 1 - confidence, the part in which the truth may be missed, a tenth is for breaking off between two looks
(`confidence_sequence`), half of the rest for the last look, and the earlier ones share what is left. So all of them
together hold the truth with the confidence, whichever is the last (Boole's inequality); nothing is assumed of the
share.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

from kitrobot.experiments.statistics.confidence_sequence import anytime_ends
from kitrobot.experiments.statistics.interval import (
    USUAL_CONFIDENCE,
    Interval,
    StatisticsError,
    check_confidence,
)
from kitrobot.experiments.statistics.shares import clopper_pearson
from kitrobot.text.sentences import Sentence

FINEST_PRECISION = 1e-3
"""Of a share: more than a million runs."""
_GROWTH = 1.4
_ANY_TIME = 0.1
"""The part of 1 - confidence that is for breaking off between two looks."""
_LAST = 0.5
"""The part of the rest that the last look may use."""


def hoeffding_runs(precision: float, confidence: float = USUAL_CONFIDENCE) -> int:
    """So many independent runs know any share to ± the precision with that confidence, by Chernoff and Hoeffding.

    That is ln(2 / (1 - confidence)) / (2 precision²), for a number of runs that is chosen beforehand (Hoeffding 1963).

    Raises:
        StatisticsError: a number makes no sense.

    Examples:
        >>> hoeffding_runs(0.01, 0.95)
        18445
    """
    check_confidence(confidence)
    _check_precision(precision)
    return math.ceil(math.log(2 / (1 - confidence)) / (2 * precision**2))


@dataclass(frozen=True, slots=True)
class InterimLook:
    """A planned look after so many runs; its interval misses the truth on either side at most so often (`tail`)."""

    runs: int
    tail: float


@dataclass(frozen=True, slots=True)
class LookPlan:
    """When it is looked; `looks` are ascending, at least one.

    Attributes:
        precision: how far the share may be from the estimate.
        confidence: how often it is no further.
        looks: the planned looks.
        missing: how often an interval between two looks may miss the truth, at any time.
    """

    precision: float
    confidence: float
    looks: tuple[InterimLook, ...]
    missing: float

    @property
    def most_runs(self) -> int:
        """The runs of the last look."""
        return self.looks[-1].runs


def plan_looks(precision: float, confidence: float = USUAL_CONFIDENCE, most_runs: int | None = None) -> LookPlan:
    """The looks for a precision (of a share, more than 0 and less than 0.5) and a confidence (between 0 and 1).

    Args:
        precision: how far the share may be from the estimate.
        confidence: how often it is no further.
        most_runs: the last look comes then at the latest, and may be less precise.

    Raises:
        StatisticsError: a number makes no sense.
    """
    check_confidence(confidence)
    _check_precision(precision)
    if most_runs is not None and most_runs < 1:
        raise StatisticsError(Sentence("there is no run to count"), Sentence("let at least one run end"))
    between = (1 - confidence) * _ANY_TIME
    missing = (1 - confidence - between) / 2
    last = _enough_runs(precision, missing * _LAST)
    if most_runs is not None:
        last = min(last, most_runs)
    count = 1
    while True:
        tail = missing * (1 - _LAST) / count
        sizes = list(_sizes(precision, tail, last))
        if len(sizes) <= count:
            break
        count = len(sizes)
    earlier = tuple(InterimLook(size, tail) for size in sizes)
    return LookPlan(precision, confidence, (*earlier, InterimLook(last, missing * (_LAST if earlier else 1))), between)


def _sizes(precision: float, tail: float, last: int) -> Iterator[int]:
    """The runs of the looks before the last one: from the first number after which an interval can be narrow enough."""
    size = math.log(tail) / math.log1p(-precision)
    while math.ceil(size) < last:
        yield math.ceil(size)
        size *= _GROWTH


def _enough_runs(precision: float, tail: float) -> int:
    """So many runs that the exact interval reaches no further than the precision, whatever the share."""
    low, high = 1, 2
    while _reach(high // 2, high, tail) > precision:
        low, high = high, 2 * high
    while high - low > 1:
        middle = (low + high) // 2
        if _reach(middle // 2, middle, tail) > precision:
            low = middle
        else:
            high = middle
    while _widest(high, tail) > precision:
        high += 1
    return high


def _widest(runs: int, tail: float) -> float:
    """How far the exact interval of so many runs reaches from the estimate where it reaches furthest.

    That is a little below one half, and as far above it; on both sides it reaches less and less far.
    """
    low, high = 0, runs // 2
    while high - low > 2:
        left, right = low + (high - low) // 3, high - (high - low) // 3
        if _reach(left, runs, tail) < _reach(right, runs, tail):
            low = left + 1
        else:
            high = right
    return max(_reach(successes, runs, tail) for successes in range(low, high + 1))


def _reach(successes: int, runs: int, tail: float) -> float:
    low, high = clopper_pearson(successes, runs, tail)
    return max(successes / runs - low, high - successes / runs)


def _check_precision(precision: float) -> None:
    if not FINEST_PRECISION <= precision < 0.5:
        raise StatisticsError(
            Sentence("expected a precision from {least} to less than 0.5, found {found}", FINEST_PRECISION, precision),
            Sentence("0.01 means that a share of 0.93 is known to lie between 0.92 and 0.94"),
        )


class SequentialShare:
    """A share that becomes known run by run, until a planned look is narrow enough or the last one is there.

    Args:
        plan: the looks.
    """

    def __init__(self, plan: LookPlan) -> None:
        self._plan = plan
        self._next = 0
        self.runs = 0
        self.successes = 0
        self.is_over = False
        self._look_interval: Interval | None = None
        self._looked_at = 0

    def add(self, success: bool) -> bool:
        """Counts the next run; whether it is the last one."""
        assert not self.is_over, "no run is counted after the end"
        self.runs += 1
        self.successes += success
        look = self._plan.looks[self._next]
        if self.runs == look.runs:
            self._look(look)
        return self.is_over

    def _look(self, look: InterimLook) -> None:
        low, high = clopper_pearson(self.successes, self.runs, look.tail)
        words = Sentence("Clopper and Pearson's exact interval at planned looks")
        interval = Interval(self.successes / self.runs, low, high, self._plan.confidence, words)
        self._look_interval, self._looked_at = interval, self.runs
        self._next += 1
        self.is_over = self._next == len(self._plan.looks) or interval.error <= self._plan.precision

    def known(self) -> tuple[Interval | None, int]:
        """The interval that is known so far, with the confidence of the plan, and of how many runs it is.

        That is the one of the last look or, between two looks, of all runs so far, if it is narrower; both hold
        whenever somebody breaks off. None before the first run.
        """
        if self.is_over or not self.runs:
            return self._look_interval, self._looked_at
        low, high = anytime_ends(self.successes, self.runs, self._plan.missing)
        words = Sentence("beta-binomial confidence sequence")
        now = Interval(self.successes / self.runs, low, high, self._plan.confidence, words)
        if self._look_interval is not None and self._look_interval.error <= now.error:
            return self._look_interval, self._looked_at
        return now, self.runs
