"""The distributions behind intervals, held against SciPy."""

from __future__ import annotations

import random

import pytest
import scipy

from kitrobot.experiments.statistics.special_functions import (
    beta_cdf,
    beta_quantile,
    normal_cdf,
    normal_quantile,
    t_bound,
    t_two_sided,
)

NUMBERS = random.Random(7)
SHAPES = [(1.0, 1.0), (1, 2), (2, 1), (1, 1e6), (1e6, 1), (5e5, 5e5), (1e6, 1e6)] + [
    (10 ** NUMBERS.uniform(0, 6), 10 ** NUMBERS.uniform(0, 6)) for _ in range(60)
]
CHANCES = [1e-9, 1e-4, 0.00125, 0.025, 0.3, 0.5, 0.9, 0.975, 0.999999]


@pytest.mark.parametrize("probability", CHANCES)
def test_quantiles_of_the_beta_distribution_are_those_of_scipy(probability: float) -> None:
    for a, b in SHAPES:
        expected = scipy.stats.beta.ppf(probability, a, b)
        assert beta_quantile(probability, a, b) == pytest.approx(expected, rel=1e-9), (a, b)


def test_the_beta_distribution_is_that_of_scipy() -> None:
    for a, b in SHAPES:
        for x in (0.001, 0.2, a / (a + b), 0.7, 0.9999):
            assert beta_cdf(x, a, b) == pytest.approx(scipy.stats.beta.cdf(x, a, b), rel=1e-7, abs=1e-12), (x, a, b)


def test_the_ends_of_the_beta_distribution_are_0_and_1() -> None:
    assert [beta_cdf(x, 2, 3) for x in (-1, 0, 1, 2)] == [0, 0, 1, 1]
    assert [beta_quantile(p, 2, 3) for p in (0, 1)] == [0, 1]


@pytest.mark.parametrize("degrees", [1, 2, 3, 10, 1000, 1e6])
def test_students_t_is_that_of_scipy(degrees: float) -> None:
    for confidence in (1e-6, 0.1, 0.5, 0.9, 0.95, 0.9999999):
        expected = scipy.stats.t.ppf((1 + confidence) / 2, degrees)
        assert t_bound(confidence, degrees) == pytest.approx(expected, rel=1e-8), confidence
    for t in (-3.0, 0.0, 0.5, 40.0):
        assert t_two_sided(t, degrees) == pytest.approx(2 * scipy.stats.t.sf(abs(t), degrees), rel=1e-8), t


def test_the_normal_distribution_is_that_of_scipy() -> None:
    for probability in CHANCES:
        assert normal_quantile(probability) == pytest.approx(scipy.stats.norm.ppf(probability), rel=1e-9, abs=1e-12)
    assert normal_cdf(1.3) == pytest.approx(scipy.stats.norm.cdf(1.3))
