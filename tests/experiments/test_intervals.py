"""Intervals of shares, means and differences: against SciPy, against enumerated cases, and how often they hold."""

from __future__ import annotations

import math
import random
from collections.abc import Callable

import pytest
import scipy

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.experiments.statistics.interval import Interval, StatisticsError
from kitrobot.experiments.statistics.means import (
    mean_interval,
    paired_difference,
    paired_test,
    unpaired_difference,
    unpaired_test,
)
from kitrobot.experiments.statistics.multiple_comparisons import holm
from kitrobot.experiments.statistics.shares import ShareMethod, share_difference, share_interval, share_test
from tests.effort import THOROUGH, cases

STUDIES = 10_000 if THOROUGH else 400
"""Simulated studies of each kind."""
ONES = [58.2, 61.0, 60.4, 59.9, 57.1, 63.3, 60.0]
OTHERS = [59.0, 61.5, 60.1, 62.2, 58.8, 64.0, 61.7]


@pytest.mark.parametrize("method", ["wilson", "exact"])
@pytest.mark.parametrize("confidence", [0.5, 0.9, 0.95, 0.999])
def test_a_share_has_the_interval_of_scipy(method: ShareMethod, confidence: float) -> None:
    for runs in (1, 2, 7, 30, 1000, 20_000):
        for successes in {0, 1, runs // 3, runs // 2, runs - 1, runs}:
            found = share_interval(successes, runs, confidence, method)
            oracle = scipy.stats.binomtest(successes, runs).proportion_ci(confidence, method)
            expected = oracle.low, oracle.high
            assert (found.low, found.high) == pytest.approx(expected, rel=1e-8, abs=1e-12), (successes, runs)
            assert found.low <= found.estimate == successes / runs <= found.high


def coverage(method: ShareMethod, runs: int, share: float) -> float:
    """How often the interval of so many runs holds the share: over all that may come out."""
    held = 0.0
    for successes, weight in enumerate(scipy.stats.binom.pmf(range(runs + 1), runs, share)):
        found = share_interval(successes, runs, 0.95, method)
        held += weight * (found.low <= share <= found.high)
    return held


def test_the_exact_interval_holds_every_share_often_enough_and_wilsons_in_the_mean() -> None:
    shares = [number / 40 for number in range(1, 40)]
    assert min(coverage("exact", 20, share) for share in shares) >= 0.95
    wilson = [coverage("wilson", 20, share) for share in shares]
    assert 0.94 < sum(wilson) / len(wilson) < 0.97


@pytest.mark.parametrize("method", ["wilson", "exact"])
def test_more_runs_and_less_confidence_make_a_share_narrower(method: ShareMethod) -> None:
    errors = [share_interval(runs // 4, runs, 0.95, method).error for runs in (4, 40, 400)]
    assert errors == sorted(errors, reverse=True)
    assert share_interval(3, 10, 0.8, method).error < share_interval(3, 10, 0.99, method).error


def test_a_mean_has_the_interval_of_scipy() -> None:
    for confidence in (0.5, 0.95, 0.999):
        found = mean_interval(ONES, confidence)
        oracle = scipy.stats.t.interval(
            confidence, len(ONES) - 1, loc=sum(ONES) / len(ONES), scale=scipy.stats.sem(ONES)
        )
        assert (found.low, found.high) == pytest.approx(oracle)
        assert found.estimate == pytest.approx(sum(ONES) / len(ONES))


def test_the_bootstrap_comes_near_that_of_scipy_and_is_decided_by_its_seed() -> None:
    values = [5.0 * 1.17**n for n in range(25)]
    found = mean_interval(values, 0.9, "bootstrap", 4)
    oracle = scipy.stats.bootstrap(
        (values,), lambda v, axis: v.mean(axis), confidence_level=0.9, n_resamples=20_000, rng=1
    )
    width = oracle.confidence_interval.high - oracle.confidence_interval.low
    assert found.low == pytest.approx(oracle.confidence_interval.low, abs=width / 20)
    assert found.high == pytest.approx(oracle.confidence_interval.high, abs=width / 20)
    assert found == mean_interval(values, 0.9, "bootstrap", 4) != mean_interval(values, 0.9, "bootstrap", 5)
    assert found.method == "bootstrap (BCa), 2000 resamples, seed 4"


def test_a_paired_difference_is_that_of_scipys_paired_test() -> None:
    oracle = scipy.stats.ttest_rel(OTHERS, ONES)
    interval = oracle.confidence_interval(0.95)
    found = paired_difference(ONES, OTHERS)
    assert (found.low, found.high) == pytest.approx((interval.low, interval.high))
    assert paired_test(ONES, OTHERS) == pytest.approx(oracle.pvalue)


def test_pairs_that_all_differ_alike_leave_no_doubt() -> None:
    assert paired_test([1, 2, 3], [2, 3, 4]) == 0
    assert paired_test([1, 2, 3], [1, 2, 3]) == 1
    found = paired_difference([1, 2, 3], [2, 3, 4])
    assert (found.low, found.estimate, found.high) == (1, 1, 1)


@pytest.mark.parametrize("others", [OTHERS, OTHERS[:3], [40.0, 80.0, 61.0, 5.0]])
@pytest.mark.parametrize("scale", [1.0, 1e-200, 1e200])
def test_an_unpaired_difference_is_that_of_scipys_test_by_welch(others: list[float], scale: float) -> None:
    oracle = scipy.stats.ttest_ind(others, ONES, equal_var=False)
    interval = oracle.confidence_interval(0.9)
    scaled = [one * scale for one in ONES], [one * scale for one in others]
    found = unpaired_difference(*scaled, 0.9)
    assert (found.low / scale, found.high / scale) == pytest.approx((interval.low, interval.high))
    assert unpaired_test(*scaled) == pytest.approx(oracle.pvalue)
    assert found.method == "Welch's t interval"


def test_values_that_never_differ_leave_no_doubt_unpaired_either() -> None:
    assert unpaired_test([1, 1, 1], [2, 2]) == 0
    assert unpaired_test([1, 1], [1, 1, 1]) == 1
    found = unpaired_difference([1, 1, 1], [2, 2])
    assert (found.low, found.estimate, found.high) == (1, 1, 1)
    assert 0 < unpaired_test([1, 1, 1], [1, 2]) < 1


def zeros_and_ones(successes: int, runs: int) -> list[int]:
    return [1] * successes + [0] * (runs - successes)


@pytest.mark.parametrize(
    ("first", "second", "low", "high"),
    [
        ((48, 80), (56, 70), 0.0524, 0.3339),
        ((3, 10), (9, 10), 0.1705, 0.8090),
        ((2, 7), (6, 7), 0.0582, 0.8062),
        ((0, 29), (5, 56), -0.0381, 0.1926),
        ((0, 10), (0, 10), -0.2775, 0.2775),
        ((0, 10), (10, 10), 0.6075, 1.0),
    ],
)
def test_a_difference_of_shares_is_that_of_newcombes_table(
    first: tuple[int, int], second: tuple[int, int], low: float, high: float
) -> None:
    found = share_difference(zeros_and_ones(*first), zeros_and_ones(*second))
    assert (found.low, found.high) == pytest.approx((low, high), abs=5e-5)


def test_differences_of_shares_hold_the_truth_about_as_often_as_they_say() -> None:
    runs, others = 15, 20
    intervals = [
        [share_difference(zeros_and_ones(n, runs), zeros_and_ones(m, others)) for m in range(others + 1)]
        for n in range(runs + 1)
    ]
    held = []
    for first in (0.1, 0.3, 0.5, 0.8):
        for second in (0.1, 0.4, 0.7, 0.9):
            ours = scipy.stats.binom.pmf(range(runs + 1), runs, first)
            theirs = scipy.stats.binom.pmf(range(others + 1), others, second)
            held.append(
                sum(
                    ours[n] * theirs[m] * (found.low <= second - first <= found.high)
                    for n, line in enumerate(intervals)
                    for m, found in enumerate(line)
                )
            )
    assert min(held) > 0.92
    assert 0.945 < sum(held) / len(held) < 0.98


def test_a_test_of_shares_is_fishers() -> None:
    for runs, others in ((1, 1), (3, 9), (12, 12), (200, 150)):
        for ours in {0, 1, runs // 3, runs}:
            for theirs in {0, 1, others // 2, others}:
                oracle = scipy.stats.fisher_exact([[ours, runs - ours], [theirs, others - theirs]])
                found = share_test(zeros_and_ones(ours, runs), zeros_and_ones(theirs, others))
                assert found == pytest.approx(oracle.pvalue), (ours, runs, theirs, others)


def test_holm_multiplies_the_smallest_most_and_keeps_their_order() -> None:
    assert holm([0.01, 0.04, 0.03]) == pytest.approx([0.03, 0.06, 0.06])
    assert holm([0.5, 0.9]) == [1.0, 1.0]
    assert holm([0.02]) == [0.02]


def test_holm_finds_a_difference_where_there_is_none_in_at_most_one_of_twenty_studies() -> None:
    chance = random.Random(11)
    wrong = sum(min(holm([chance.random() for _ in range(5)])) < 0.05 for _ in range(20 * STUDIES))
    assert wrong <= scipy.stats.binom.ppf(1 - 1e-6, 20 * STUDIES, 0.05)


def holding(studies: int, draw: Callable[[random.Random], Interval], truth: float) -> int:
    """In how many simulated studies the interval holds the truth."""
    chance = random.Random(5)
    return sum(found.low <= truth <= found.high for found in (draw(chance) for _ in range(studies)))


@pytest.mark.parametrize("count", cases([2, 10], [40]))
def test_intervals_of_means_hold_the_truth_as_often_as_they_say(count: int) -> None:
    held = holding(STUDIES, lambda chance: mean_interval([chance.gauss(60, 4) for _ in range(count)]), 60)
    low, high = (scipy.stats.binom.ppf(end, STUDIES, 0.95) for end in (1e-6, 1 - 1e-6))
    assert low <= held <= high


def test_bootstrap_intervals_of_lopsided_values_hold_the_truth_nearly_as_often_as_they_say() -> None:
    studies = STUDIES // 10

    def draw(chance: random.Random) -> Interval:
        return mean_interval([chance.expovariate(1 / 60) for _ in range(30)], 0.95, "bootstrap", chance.randrange(99))

    assert holding(studies, draw, 60) >= scipy.stats.binom.ppf(1e-4, studies, 0.9)


@pytest.mark.parametrize(
    ("ask", "sentence"),
    [
        (lambda: share_interval(0, 0), "there is no run to count"),
        (lambda: share_interval(3, 2), "something holds in 3 of 2 runs"),
        (lambda: share_interval(-1, 2), "something holds in -1 of 2 runs"),
        (lambda: share_interval(0.5, 2), "as whole numbers"),  # type: ignore[arg-type]
        (lambda: share_interval(1, 2, 1.0), "expected a confidence between 0 and 1, found 1"),
        (lambda: share_interval(1, 2, math.nan), "expected a confidence between 0 and 1, found nan"),
        (lambda: mean_interval([]), "there are 0 values, and 2 are needed at least"),
        (lambda: mean_interval([1.0]), "there is 1 value, and 2 are needed at least"),
        (lambda: mean_interval([1.0, math.nan]), "value 2 is nan, which is no finite number"),
        (lambda: mean_interval([math.inf, 1.0]), "value 1 is inf"),
        (lambda: mean_interval([10**400, 1.0]), "value 1 is 1000"),
        (lambda: mean_interval(["fast", 1.0]), "value 1 is fast"),  # type: ignore[list-item]
        (lambda: paired_difference([1, 2], [1, 2, 3]), "there are 2 values of one and 3 of the other"),
        (lambda: paired_test([1], [1]), "there is 1 value"),
        (lambda: unpaired_test([1, 2], [1]), "there is 1 value, and 2 are needed at least"),
        (lambda: unpaired_difference([1, math.nan], [1, 2]), "value 2 is nan"),
        (lambda: share_difference([], [1]), "there is no run to count"),
        (lambda: share_test([1], []), "there is no run to count"),
        (lambda: holm([]), "there are 0 values"),
        (lambda: holm([0.5, 1.5]), "p-value 2 is 1.5"),
        (lambda: holm([math.nan]), "value 1 is nan"),
    ],
)
def test_numbers_of_which_nothing_can_be_said_are_an_error_that_says_what_to_do(
    ask: Callable[[], object], sentence: str
) -> None:
    with pytest.raises(StatisticsError, match=sentence) as raised:
        ask()
    assert isinstance(raised.value, ValueError)
    assert isinstance(raised.value, KitRobotError)
    assert raised.value.help


def test_the_largest_and_the_smallest_numbers_have_a_mean() -> None:
    for scale in (1e308, 1e-308):
        found = mean_interval([scale, scale / 2, scale / 4])
        assert found.low < found.estimate < found.high
        assert math.isfinite(found.estimate)
    assert mean_interval([0.0, 0.0]).high == 0
