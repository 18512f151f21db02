"""The simulator's tables of a team say what the protocol's say, whatever robots do and whichever fail."""

from __future__ import annotations

import random
from collections import Counter

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kitrobot.compiler import PointKind
from kitrobot.team.charter import Failure
from tests.effort import examples
from tests.team.tables_of_simulator import Pair

FAILURES: tuple[Failure, ...] = ("drop", "substitute", "abort")


def done_at_random(pair: Pair, chance: random.Random, most: int) -> None:
    """So many things are done to both, until the team is over; what is waited for comes more often than chance."""
    for _ in range(most):
        if pair.is_over:
            return
        i, choice = chance.randrange(pair.count), chance.random()
        if choice < 0.45:
            there = [at[0] for at in pair.standing if at]
            p = chance.choice(there) if there and chance.random() < 0.8 else chance.randrange(len(pair.points))
            pair.comes(i, p, chance.randrange(2))
        elif choice < 0.65:
            pair.takes(i, chance.randrange(2))
        elif choice < 0.82:
            pair.finishes(i, chance.randrange(2))
        elif choice < 0.9:
            pair.waits(chance.choice((1, 10, 25, 50)))
        elif choice < 0.94:
            pair.fails(i, chance.choice(("fail", "stall", "mute")))
        else:
            pair.comes_back(i)


@given(st.sampled_from(FAILURES), st.integers(0, 4), st.integers(0, 10**9))
@settings(max_examples=examples(40))
def test_both_say_who_has_met_who_holds_a_unit_and_what_is_free_again(failure: Failure, units: int, seed: int) -> None:
    chance = random.Random(seed)
    done_at_random(Pair(failure, units, chance), chance, 150)


@pytest.mark.parametrize("failure", FAILURES)
def test_what_is_done_at_random_reaches_all_that_both_define(failure: Failure) -> None:
    found = Counter[str]()
    for seed in range(12):
        chance = random.Random(seed)
        pair = Pair(failure, 4, chance)
        done_at_random(pair, chance, 150)
        for point, passed in zip(pair.points, pair.passed, strict=True):
            found[point.kind] += passed
        found["counted"] += pair.counted
        found["late"] += pair.not_counted
        found["back"] += sum(pair.lives)
        found["substituted"] += any(i in players for players in pair.tables.players for i in (4, 5))
        found["over"] += pair.tables.aborted >= 0
    wanted = {"counted", PointKind.MEET, PointKind.ASK} | {
        "drop": {"late", "back", PointKind.MOVE},
        "substitute": {"late", "back", "substituted"},
        "abort": {"over"},
    }[failure]
    assert {name for name in wanted if not found[name]} == set()
