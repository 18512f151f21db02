"""Stopping early breaks no promise: planned looks and the sequential ratio test, over all that may come out."""

from __future__ import annotations

import functools
import math
import random
from typing import Any

import numpy as np
import pytest
import scipy

from kitrobot.experiments.statistics import stopping_rule
from kitrobot.experiments.statistics.confidence_sequence import anytime_ends
from kitrobot.experiments.statistics.interval import StatisticsError
from kitrobot.experiments.statistics.ratio_test import RatioTest
from kitrobot.experiments.statistics.shares import clopper_pearson
from kitrobot.experiments.statistics.stopping_rule import (
    LookPlan,
    SequentialShare,
    hoeffding_runs,
    plan_looks,
)
from tests.effort import THOROUGH, cases

STUDIES = 10_000 if THOROUGH else 300


@pytest.fixture
def known_ends(monkeypatch: pytest.MonkeyPatch) -> None:
    """The ends of an interval are computed once."""
    monkeypatch.setattr(stopping_rule, "clopper_pearson", functools.cache(clopper_pearson))


def test_hoeffdings_runs_are_those_of_the_formula() -> None:
    assert hoeffding_runs(0.01, 0.95) == 18445 == math.ceil(math.log(40) / (2 * 0.0001))
    assert hoeffding_runs(0.05, 0.99) == 1060


@pytest.mark.parametrize("precision", cases([0.2, 0.1, 0.05], [0.02, 0.01]))
def test_the_last_look_is_precise_whatever_comes_out_and_comes_before_hoeffdings_bound(precision: float) -> None:
    plan = plan_looks(precision)
    assert [look.runs for look in plan.looks] == sorted({look.runs for look in plan.looks})
    assert plan.most_runs < hoeffding_runs(precision)
    last = plan.looks[-1]
    for successes in range(0, last.runs + 1, max(1, last.runs // 1000)):
        low, high = clopper_pearson(successes, last.runs, last.tail)
        assert max(successes / last.runs - low, high - successes / last.runs) <= precision + 1e-12


@pytest.mark.parametrize("precision", [0.3, 0.05, 0.01])
def test_all_looks_together_may_miss_no_more_than_the_confidence_leaves(precision: float) -> None:
    for confidence in (0.8, 0.95, 0.999):
        plan = plan_looks(precision, confidence)
        used = plan.missing + 2 * sum(look.tail for look in plan.looks)
        assert 0.8 * (1 - confidence) < used <= 1 - confidence + 1e-12


def exact_coverage(plan: LookPlan, share: float) -> tuple[float, float]:
    """How often the interval of the look at which it stops holds the share, and is precise enough: over all runs."""
    going = np.array([1.0])
    before, held, precise = 0, 0.0, 0.0
    for look in plan.looks:
        going = np.convolve(going, scipy.stats.binom.pmf(range(look.runs - before + 1), look.runs - before, share))
        before = look.runs
        for successes in range(look.runs + 1):
            if going[successes] < 1e-15:
                going[successes] = 0
                continue
            low, high = clopper_pearson(successes, look.runs, look.tail)
            estimate = successes / look.runs
            if look is plan.looks[-1] or max(estimate - low, high - estimate) <= plan.precision:
                held += going[successes] * (low <= share <= high)
                precise += going[successes] * (abs(estimate - share) <= plan.precision)
                going[successes] = 0
    return held, precise


@pytest.mark.parametrize("confidence", cases([0.8], [0.95, 0.5]))
def test_every_share_is_held_with_the_confidence_although_it_is_stopped_early(confidence: float) -> None:
    plan = plan_looks(0.1, confidence)
    assert len(plan.looks) > 1
    for share in [0.003, 0.02, 0.05, 0.11, 0.3, 0.5, 0.77, 0.9, 0.99]:
        held, precise = exact_coverage(plan, share)
        assert held >= confidence, share
        assert precise >= confidence, share


def test_what_is_known_holds_the_share_whenever_somebody_breaks_off(known_ends: None) -> None:
    """The worst that somebody can do: to break off as soon as the interval misses."""
    plan, chance = plan_looks(0.1, 0.8), random.Random(2)
    missed = 0
    for _ in range(STUDIES // 3):
        share, is_over = SequentialShare(plan), False
        while not is_over:
            is_over = share.add(chance.random() < 0.9)
            interval, _ = share.known()
            assert interval is not None
            if not interval.low <= 0.9 <= interval.high:
                missed += 1
                break
    assert missed <= scipy.stats.binom.ppf(1 - 1e-6, STUDIES // 3, 0.2)


@pytest.mark.parametrize("share", cases([0.5, 0.97], [0.05, 0.8]))
def test_a_confidence_sequence_misses_at_any_time_no_more_often_than_it_says(share: float) -> None:
    missing, ever = 0.2, 0.0
    going = np.array([1.0])
    for runs in range(1, 301):
        going = np.convolve(going, [1 - share, share])
        for successes in np.flatnonzero(going > 1e-9):
            low, high = anytime_ends(int(successes), runs, missing)
            if not low <= share <= high:
                ever += going[successes]
                going[successes] = 0
    assert 0.02 < ever <= missing


def test_simulated_studies_hold_the_share_and_what_is_nearly_certain_takes_fewer_runs(known_ends: None) -> None:
    plan, chance = plan_looks(0.05), random.Random(3)
    for truth in (0.5, 0.95, 1.0):
        held, runs = 0, 0
        for _ in range(STUDIES):
            share = SequentialShare(plan)
            while not share.add(chance.random() < truth):
                pass
            interval, _ = share.known()
            assert interval is not None
            assert interval.error <= 0.05 + 1e-12
            held += interval.low <= truth <= interval.high
            runs += share.runs
        assert held >= scipy.stats.binom.ppf(1e-6, STUDIES, 0.95)
        assert (runs / STUDIES < 0.7 * plan.most_runs) == (truth > 0.9)


def test_what_is_known_says_of_how_many_runs_it_is_and_by_which_method() -> None:
    plan = plan_looks(0.2)
    share, first = SequentialShare(plan), plan.looks[0].runs
    assert share.known() == (None, 0)
    for _ in range(first - 1):
        share.add(True)
    interval, runs = share.known()
    assert interval is not None
    assert (interval.estimate, interval.high, runs) == (1.0, 1.0, first - 1)
    assert (interval.method, interval.confidence) == ("beta-binomial confidence sequence", 0.95)
    assert share.add(True)
    interval, runs = share.known()
    assert interval is not None
    assert (interval.estimate, runs, share.is_over) == (1.0, first, True)
    assert interval.method == "Clopper and Pearson's exact interval at planned looks"


@pytest.mark.parametrize("most", [1, 5, 40])
def test_a_limit_of_runs_is_the_last_look_and_leaves_the_interval_as_wide_as_it_is(most: int) -> None:
    plan = plan_looks(0.01, 0.95, most)
    assert plan.most_runs == most
    assert plan.missing + 2 * sum(look.tail for look in plan.looks) <= 0.05 + 1e-12


def decisions(threshold: float, margin: float, confidence: float, share: float) -> tuple[float, float, float]:
    """How often the ratio test says yes and no, and how many runs it takes: over all that may come out."""
    weights: dict[int, float] = {0: 1.0}
    yes = no = mean = 0.0
    runs = 0
    while sum(weights.values()) > 1e-6:
        runs += 1
        following: dict[int, float] = {}
        for successes, weight in weights.items():
            for success, part in ((1, weight * share), (0, weight * (1 - share))):
                following[successes + success] = following.get(successes + success, 0.0) + part
        weights = {}
        for successes, weight in following.items():
            decision = decided(threshold, margin, confidence, successes, runs)
            if decision is None:
                weights[successes] = weight
                continue
            yes, no = yes + weight * decision, no + weight * (not decision)
            mean += runs * weight
    return yes, no, mean


def decided(threshold: float, margin: float, confidence: float, successes: int, runs: int) -> bool | None:
    test = RatioTest(threshold, margin, confidence)
    test.runs, test.successes = runs - 1, successes
    test.add(False)
    return test.decision


@pytest.mark.parametrize(("threshold", "margin", "confidence"), [(0.9, 0.05, 0.95), (0.5, 0.1, 0.9), (0.2, 0.15, 0.99)])
def test_the_ratio_test_errs_no_more_often_than_it_says(threshold: float, margin: float, confidence: float) -> None:
    _, wrong, _ = decisions(threshold, margin, confidence, threshold + margin)
    assert 0 < wrong <= 1 - confidence
    wrong, _, _ = decisions(threshold, margin, confidence, threshold - margin)
    assert 0 < wrong <= 1 - confidence
    _, far, mean = decisions(threshold, margin, confidence, min(0.999, threshold + 2 * margin))
    assert far < wrong
    assert mean < hoeffding_runs(margin, confidence)


def test_the_ratio_test_ends_also_where_either_answer_is_right() -> None:
    yes, no, _ = decisions(0.5, 0.2, 0.9, 0.5)
    assert yes + no == pytest.approx(1, abs=1e-5)
    assert yes == pytest.approx(no, abs=1e-5)


@pytest.mark.parametrize(
    ("ask", "sentence"),
    [
        (lambda: plan_looks(0), "expected a precision from 0.001 to less than 0.5, found 0"),
        (lambda: plan_looks(0.5), "found 0.5"),
        (lambda: plan_looks(math.nan), "found nan"),
        (lambda: plan_looks(1e-9), "expected a precision"),
        (lambda: plan_looks(0.1, 0), "expected a confidence between 0 and 1, found 0"),
        (lambda: plan_looks(0.1, 0.9, 0), "there is no run to count"),
        (lambda: hoeffding_runs(-0.1), "expected a precision"),
        (lambda: RatioTest(1, 0.01), "expected a share between 0 and 1 to compare with, found 1"),
        (lambda: RatioTest(math.nan, 0.01), "found nan"),
        (lambda: RatioTest(0.95, 0.05), "0.95 cannot be told from 0.95 ± 0.05"),
        (lambda: RatioTest(0.5, 0), "0.5 cannot be told"),
        (lambda: RatioTest(0.5, math.nan), "0.5 cannot be told"),
        (lambda: RatioTest(0.5, 0.1, 2), "expected a confidence"),
    ],
)
def test_numbers_that_make_no_plan_are_an_error_that_says_what_to_do(ask: Any, sentence: str) -> None:
    with pytest.raises(StatisticsError, match=sentence) as raised:
        ask()
    assert raised.value.help
