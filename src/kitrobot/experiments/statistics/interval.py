"""An interval for a number that runs can only estimate, and what every statistic asks of its numbers."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from operator import index

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.text.sentences import Sentence

USUAL_CONFIDENCE = 0.95


class StatisticsError(KitRobotError, ValueError):
    """Numbers of which nothing can be said, with what to do."""


@dataclass(frozen=True, slots=True)
class Interval:
    """What is known of a number.

    Attributes:
        estimate: the best guess, `low` ≤ `estimate` ≤ `high`.
        low, high: where the number is.
        confidence: the share (0…1) of intervals made so that hold their number.
        method: what the interval was computed by.
    """

    estimate: float
    low: float
    high: float
    confidence: float
    method: Sentence

    @property
    def error(self) -> float:
        """How far the estimate is from the further end."""
        return max(self.estimate - self.low, self.high - self.estimate)


def check_confidence(confidence: float) -> None:
    """That it lies between 0 and 1.

    Raises:
        StatisticsError: it does not; NaN never does.
    """
    if not 0 < confidence < 1:
        raise StatisticsError(
            Sentence("expected a confidence between 0 and 1, found {found}", f"{confidence:g}"),
            Sentence("0.95 is the usual one: 19 of 20 such intervals hold the truth"),
        )


def check_counts(successes: int, runs: int) -> tuple[int, int]:
    """Both as whole numbers, with 0 ≤ successes ≤ runs and at least one run.

    Raises:
        StatisticsError: they are not.
    """
    try:
        successes, runs = index(successes), index(runs)
    except TypeError:
        raise StatisticsError(
            Sentence("expected how many runs there are, and in how many something holds, as whole numbers"),
            Sentence("count the runs, and give no share"),
        ) from None
    if runs < 1:
        raise StatisticsError(Sentence("there is no run to count"), Sentence("let at least one run end"))
    if not 0 <= successes <= runs:
        raise StatisticsError(
            Sentence("something holds in {count} of {runs} runs", successes, runs),
            Sentence("count each run once: the number is from 0 to {runs}", runs),
        )
    return successes, runs


def check_values(values: Iterable[float], least: int) -> list[float]:
    """The values as finite floats, at least so many.

    Raises:
        StatisticsError: one is no finite number, or there are too few.
    """
    values = list(values)
    try:
        found = list(map(float, values))
        # A sum is finite only where all are.
        if len(found) >= least and math.isfinite(math.fsum(found)):
            return found
    except (TypeError, ValueError, OverflowError):
        pass  # Said below, or the sum alone is too large.
    found = []
    for place, value in enumerate(values, 1):
        try:
            number = float(value)
        except (TypeError, ValueError, OverflowError):
            number = math.nan
        if not math.isfinite(number):
            raise StatisticsError(
                Sentence("value {place} is {found}, which is no finite number", place, str(value)[:40]),
                Sentence("leave out the runs that have no value, and say how many they are"),
            )
        found.append(number)
    if len(found) < least:
        raise StatisticsError(
            Sentence.counted(
                "there is {count} value, and {least} are needed at least",
                "there are {count} values, and {least} are needed at least",
                len(found),
                least,
            ),
            Sentence("let more runs end"),
        )
    return found
