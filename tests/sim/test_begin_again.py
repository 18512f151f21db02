"""A run that begins again with another seed is the run that a new one would be."""

from __future__ import annotations

import pytest

import kitrobot
from tests.effort import cases

MISSIONS = cases(["transport-team", "dice", "line-follower"], ["transport", "exchange", "search", "sumo", "tidy-up"])


@pytest.mark.parametrize("name", MISSIONS)
def test_a_run_that_begins_again_is_a_new_run_with_that_seed(name):
    opened = kitrobot.open_mission(name)
    again = opened.simulation(seed=1, fail_rate=0.9, seconds=8)
    again.keep_beginning()
    for seed in (7, 1, 7):
        new = opened.simulation(seed=seed, fail_rate=0.9, seconds=8)
        again.begin_again(seed)
        assert again.identity == new.identity
        while new.outcome is None:
            new.advance(100)
        while again.outcome is None:
            again.advance(100)
        assert (again.outcome, again.sentence, again.seed) == (new.outcome, new.sentence, seed)
        assert again.snapshot() == new.snapshot()
