"""Intervals for a mean, and for the difference of two: of the same runs, or of runs that have nothing in common."""

from __future__ import annotations

import math
import random
from collections.abc import Iterable, Sequence
from dataclasses import replace
from operator import mul
from typing import Literal

from kitrobot.experiments.statistics.interval import (
    USUAL_CONFIDENCE,
    Interval,
    StatisticsError,
    check_confidence,
    check_values,
)
from kitrobot.experiments.statistics.special_functions import normal_cdf, normal_quantile, t_bound, t_two_sided
from kitrobot.text.sentences import Sentence

MeanMethod = Literal["t", "bootstrap"]
RESAMPLES = 2000
_TINY = 1e-9
_SMALL, _LARGE = 1e-100, 1e100
"""Between these, values are added up and squared as they are."""


def mean_interval(
    values: Iterable[float], confidence: float = USUAL_CONFIDENCE, method: MeanMethod = "t", seed: int = 1
) -> Interval:
    """The interval for the mean of which these independent values are known, in their unit.

    Args:
        values: at least two; finite.
        confidence: the share (0…1) of intervals that hold the mean.
        method: "t" (Student 1908) is exact for values of a normal distribution, and good for many of any; "bootstrap"
            (BCa; Efron 1987) follows lopsided values, and needs some twenty.
        seed: decides the bootstrap's resamples.

    Raises:
        StatisticsError: there are too few values, or one is no finite number.

    Examples:
        >>> found = mean_interval([58.0, 61.0, 60.0, 59.0])
        >>> found.estimate, round(found.low, 2), round(found.high, 2)
        (59.5, 57.45, 61.55)
    """
    check_confidence(confidence)
    scaled, scale = _scaled(check_values(values, 2))
    mean = math.fsum(scaled) / len(scaled)
    if method == "t":
        margin = t_bound(confidence, len(scaled) - 1) * _standard_error(scaled, mean)
        low, high = mean - margin, mean + margin
        words = Sentence("Student's t interval")
    else:
        low, high = _bootstrap(scaled, mean, confidence, seed)
        words = Sentence("bootstrap (BCa), {count} resamples, seed {seed}", RESAMPLES, seed)
    return Interval(mean * scale, low * scale, high * scale, confidence, words)


def paired_difference(
    first: Iterable[float],
    second: Iterable[float],
    confidence: float = USUAL_CONFIDENCE,
    method: MeanMethod = "t",
    seed: int = 1,
) -> Interval:
    """The interval for how much larger the second measure is than the first in the mean, run by run.

    Args:
        first: a value for each run.
        second: the other value of each run, in the same order; runs with the same seed make a pair.
        confidence: the share (0…1) of intervals that hold the difference.
        method: as of `mean_interval`.
        seed: as of `mean_interval`.

    Raises:
        StatisticsError: there are not as many values of both, too few, or one is no finite number.
    """
    found = mean_interval(_differences(first, second), confidence, method, seed)
    return replace(found, method=Sentence("{method} of the differences", found.method))


def paired_test(first: Iterable[float], second: Iterable[float]) -> float:
    """How probable a difference at least as large is if both are alike in the mean: the p-value of the paired t test.

    Raises:
        StatisticsError: as `paired_difference`.
    """
    scaled, _ = _scaled(check_values(_differences(first, second), 2))
    mean = math.fsum(scaled) / len(scaled)
    error = _standard_error(scaled, mean)
    if error == 0:
        return 1.0 if mean == 0 else 0.0
    return t_two_sided(mean / error, len(scaled) - 1)


def unpaired_difference(
    first: Iterable[float], second: Iterable[float], confidence: float = USUAL_CONFIDENCE
) -> Interval:
    """The interval for how much larger the second mean is than the first, of runs that are independent (Welch 1947).

    The two need neither the same number of values nor the same spread.

    Args:
        first: at least two values; finite.
        second: at least two values of other runs; finite.
        confidence: the share (0…1) of intervals that hold the difference.

    Raises:
        StatisticsError: there are too few values, or one is no finite number.

    Examples:
        >>> found = unpaired_difference([58.0, 61.0, 60.0, 59.0], [61.0, 65.0, 63.0])
        >>> found.estimate, round(found.low, 2), round(found.high, 2)
        (3.5, -0.3, 7.3)
    """
    check_confidence(confidence)
    difference, error, degrees, scale = _welch(first, second)
    margin = t_bound(confidence, degrees) * error if error else 0.0
    low, high = difference - margin, difference + margin
    return Interval(difference * scale, low * scale, high * scale, confidence, Sentence("Welch's t interval"))


def unpaired_test(first: Iterable[float], second: Iterable[float]) -> float:
    """How probable a difference at least as large is if both means are alike: the p-value of Welch's t test.

    Raises:
        StatisticsError: as `unpaired_difference`.
    """
    difference, error, degrees, _ = _welch(first, second)
    if error == 0:
        return 1.0 if difference == 0 else 0.0
    return t_two_sided(difference / error, degrees)


def _welch(first: Iterable[float], second: Iterable[float]) -> tuple[float, float, float, float]:
    """The difference of the means, its standard error, the degrees of freedom (1 without an error), and the unit."""
    ones, others = check_values(first, 2), check_values(second, 2)
    scaled, scale = _scaled([*ones, *others])
    parts = scaled[: len(ones)], scaled[len(ones) :]
    means = [math.fsum(part) / len(part) for part in parts]
    errors = [_standard_error(part, mean) for part, mean in zip(parts, means, strict=True)]
    error = math.hypot(*errors)
    if error == 0:
        return means[1] - means[0], 0.0, 1.0, scale
    uncertainty = sum((one / error) ** 4 / (len(part) - 1) for one, part in zip(errors, parts, strict=True))
    return means[1] - means[0], error, 1 / uncertainty, scale


def _differences(first: Iterable[float], second: Iterable[float]) -> list[float]:
    ones, others = check_values(first, 2), check_values(second, 2)
    if len(ones) != len(others):
        raise StatisticsError(
            Sentence("there are {count} values of one and {other} of the other", len(ones), len(others)),
            Sentence("take the runs that both have, in the same order"),
        )
    return [other - one for one, other in zip(ones, others, strict=True)]


def _scaled(values: Sequence[float]) -> tuple[Sequence[float], float]:
    """The values, and 1; where their squares could be too large or too small for a float, values of which the largest
    is 1, and in what unit these are.
    """
    scale = max(-min(values), max(values))
    if scale == 0 or _SMALL < scale < _LARGE:
        return values, 1.0
    return [value / scale for value in values], scale


def _standard_error(values: Sequence[float], mean: float) -> float:
    count = len(values)
    if min(values) == max(values):
        return 0.0
    spread = [value - mean for value in values]
    return math.sqrt(math.fsum(map(mul, spread, spread)) / (count - 1) / count)


def _bootstrap(values: Sequence[float], mean: float, confidence: float, seed: int) -> tuple[float, float]:
    """Efron's BCa interval; the acceleration of a mean is its skewness by the jackknife."""
    count = len(values)
    if min(values) == max(values):
        return mean, mean
    draw = random.Random(seed).choices
    means = sorted(math.fsum(draw(values, k=count)) / count for _ in range(RESAMPLES))
    below = sum(one < mean for one in means) + sum(one == mean for one in means) / 2
    shift = normal_quantile(min(max(below, 0.5), RESAMPLES - 0.5) / RESAMPLES)
    spread = [value - mean for value in values]
    squares = math.fsum(one**2 for one in spread)
    acceleration = math.fsum(one**3 for one in spread) / (6 * squares**1.5)

    def end(probability: float) -> float:
        at = shift + normal_quantile(probability)
        place = normal_cdf(shift + at / max(_TINY, 1 - acceleration * at)) * (RESAMPLES - 1)
        lower = int(place)
        upper = min(lower + 1, RESAMPLES - 1)
        return means[lower] + (means[upper] - means[lower]) * (place - lower)

    tail = (1 - confidence) / 2
    return min(mean, end(tail)), max(mean, end(1 - tail))
