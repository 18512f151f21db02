"""Multilevel splitting against a walk whose probability is known: unbiased, honest, and better than plain sampling."""

from __future__ import annotations

import random
import statistics

import pytest
import scipy

from kitrobot.experiments.statistics.branch_estimate import (
    BranchEnd,
    find_levels,
    plan_effort,
    split,
    split_interval,
)
from kitrobot.experiments.statistics.interval import StatisticsError
from tests.effort import THOROUGH

STUDIES = 10_000 if THOROUGH else 150
UP = 0.3
TOP = 6
TRUTH = ((1 - UP) / UP - 1) / (((1 - UP) / UP) ** TOP - 1)
"""The gambler's ruin: a walk that begins at 1 and goes up with the probability `UP` comes to `TOP` before 0."""


def walk(state: int | None, level: float, seed: int) -> BranchEnd:
    """The walk from a place to a level, or to its end at 0 or `TOP`; levels count from the place 1 on."""
    chance, place = random.Random(seed), 1 if state is None else state
    while 0 < place < TOP:
        if place > level:
            return BranchEnd(place)
        place += 1 if chance.random() < UP else -1
    return BranchEnd(None, place == TOP)


def estimates(count: int, levels: tuple[float, ...], effort: int) -> list[float]:
    return [split(walk, levels, effort, 1, number).estimate for number in range(count)]


@pytest.mark.parametrize("levels", [(), (1.0, 2.0, 3.0, 4.0), (2.0,), (1.0, 1.0, 99.0)])
def test_the_estimate_is_unbiased_whatever_the_levels_are(levels: tuple[float, ...]) -> None:
    found = estimates(10 * STUDIES, levels, 20)
    error = statistics.stdev(found) / len(found) ** 0.5
    assert abs(statistics.fmean(found) - TRUTH) < 4.5 * error


def test_good_levels_are_more_precise_than_as_many_runs_without() -> None:
    split_up = estimates(STUDIES, (1.0, 2.0, 3.0, 4.0), 40)
    plain = estimates(STUDIES, (), 200)
    assert statistics.variance(split_up) < 0.5 * statistics.variance(plain)


def test_intervals_hold_the_truth_as_often_as_they_say() -> None:
    held = 0
    for study in range(STUDIES):
        found = [split(walk, (1.0, 2.0, 3.0, 4.0), 40, study, number) for number in range(10)]
        interval = split_interval(found, 0.95)
        held += interval is not None and interval.low <= TRUTH <= interval.high
    assert held >= scipy.stats.binom.ppf(1e-4, STUDIES, 0.93)


def test_a_pilot_finds_levels_that_about_half_of_the_branches_pass() -> None:
    levels = find_levels(walk, 40, 200, 1)
    assert levels == (1.0, 2.0, 3.0, 4.0)
    assert find_levels(walk, 2, 200, 1) == (1.0, 2.0)
    assert find_levels(lambda state, level, seed: BranchEnd(level), 40, 20, 1) == ()
    assert find_levels(lambda state, level, seed: BranchEnd(None), 40, 20, 1) == ()


def test_where_most_repetitions_find_nothing_no_interval_is_given() -> None:
    seldom = [split(walk, (), 10, 1, number) for number in range(20)]
    assert 2 * sum(one.estimate > 0 for one in seldom) <= 20
    assert split_interval(seldom, 0.95) is None
    assert split_interval(seldom[:1], 0.95) is None


def test_too_few_branches_are_an_error_that_says_how_many_are_enough() -> None:
    assert plan_effort(10_000, 4, 20) == 100
    with pytest.raises(StatisticsError, match="999 branches are too few for 4 levels") as raised:
        plan_effort(999, 4, 20)
    assert raised.value.help == "let there be 1000 at least"
