"""Multilevel splitting with fixed levels and fixed effort: the probability of what hardly ever happens.

A process passes levels on its way. From the beginning `effort` branches go on until the first level or their end; from
the states in which they passed it, drawn at random, as many go on to the next one, and so on. A branch that ends counts
for as much as the levels behind it are probable, so the estimate is unbiased, whatever the levels are and whether or
not what is asked for lies behind them (P. Glasserman et al., Operations Research 47 (1999); M. Amrein and H. R. Künsch,
ACM TOMACS 21 (2011)). Good levels make it precise; levels that have nothing to do with it only cost time.

The estimate of one repetition has no known distribution, so there are several, independent of each other, and the
interval is Student's t interval of their mean. The levels are chosen by a pilot of its own, which is not counted.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, Final

from kitrobot.experiments.statistics.interval import Interval, StatisticsError, check_confidence
from kitrobot.experiments.statistics.means import mean_interval
from kitrobot.text.sentences import Sentence

MOST_LEVELS: Final = 40
USUAL_REPETITIONS: Final = 10
LEAST_EFFORT: Final = 10
"""Branches from each level that there are at least."""
_OFTEN: Final = 0.5
"""Levels are left out between which a branch passes more often than this."""


@dataclass(frozen=True, slots=True)
class BranchEnd:
    """How a branch came to its end: the state in which it passed the level, None where it ended without; and whether
    what is asked for holds then.
    """

    state: Any
    holds: bool = False


Branch = Callable[[Any, float, int], BranchEnd]
"""Goes on from a state (None: the beginning), to a level or the end, with the chance of a seed."""


@dataclass(frozen=True, slots=True)
class Repetition:
    """One estimate.

    Attributes:
        estimate: the probability.
        passed: of each level, the share of branches from the one before that passed it; 0 behind the last one passed.
        branches: how many were run.
    """

    estimate: float
    passed: tuple[float, ...]
    branches: int


def find_levels(branch: Branch, most: float, effort: int, seed: int) -> tuple[float, ...]:
    """Whole levels that a pilot passes, about half of the branches from one to the next; ascending, perhaps none.

    Args:
        branch: the process; its levels are 1, 2, 3, ….
        most: the highest that there is.
        effort: branches from each level.
        seed: decides the pilot.
    """
    chance = random.Random(f"{seed}/levels")
    states: list[Any] = [None]
    found: list[float] = []
    share = 1.0
    for level in range(1, round(min(most, MOST_LEVELS)) + 1):
        ends = (branch(chance.choice(states), level, chance.getrandbits(62)) for _ in range(effort))
        passed = [one.state for one in ends if one.state is not None]
        share *= len(passed) / effort
        if not passed:
            break
        if share <= _OFTEN:
            found.append(float(level))
            share = 1.0
        states = passed
    return tuple(found)


def split(branch: Branch, levels: Sequence[float], effort: int, seed: int, number: int) -> Repetition:
    """A repetition; the same numbers give the same one.

    Args:
        branch: the process.
        levels: ascending.
        effort: branches from each level, at least one.
        seed: decides all repetitions.
        number: of this one.
    """
    chance = random.Random(f"{seed}/{number}")
    states: list[Any] = [None]
    weight, estimate, branches = 1.0, 0.0, 0
    shares: list[float] = []
    for level in (*levels, float("inf")):
        ends = [branch(chance.choice(states), level, chance.getrandbits(62)) for _ in range(effort)]
        branches += effort
        estimate += weight * sum(one.holds for one in ends if one.state is None) / effort
        states = [one.state for one in ends if one.state is not None]
        shares.append(len(states) / effort)
        weight *= shares[-1]
        if not states:
            break
    passed = (*shares, *[0.0] * len(levels))[: len(levels)]
    return Repetition(estimate, passed, branches)


def plan_effort(runs: int, levels: int, repetitions: int) -> int:
    """Branches from each level, so that there are so many at most altogether.

    Raises:
        StatisticsError: there are too few.
    """
    effort = runs // (repetitions * (levels + 1))
    if effort < LEAST_EFFORT:
        least = LEAST_EFFORT * repetitions * (levels + 1)
        raise StatisticsError(
            Sentence("{runs} branches are too few for {levels} levels", runs, levels),
            Sentence("let there be {count} at least", least),
        )
    return effort


def split_interval(found: Sequence[Repetition], confidence: float) -> Interval | None:
    """The interval of some repetitions; None of fewer than two, and where most of them found nothing: what is said of
    numbers that are nearly all 0 would not hold.

    Raises:
        StatisticsError: the confidence is none.
    """
    check_confidence(confidence)
    estimates = [one.estimate for one in found]
    if len(estimates) < 2 or 2 * sum(one > 0 for one in estimates) <= len(estimates):
        return None
    mean = mean_interval(estimates, confidence)
    words = Sentence("Student's t interval of {count} repetitions of multilevel splitting", len(estimates))
    return Interval(mean.estimate, max(0.0, mean.low), min(1.0, mean.high), confidence, words)
