"""Whoever fails in the example `transport-team`, all boxes arrive; with any two, they do, or the run says why not."""

from __future__ import annotations

from pathlib import Path

import pytest

import kitrobot
from kitrobot.workspace import RunOptions
from kitrobot.workspace.sweep import Sweep, SweepOptions, run_sweep
from tests.effort import THOROUGH

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"


def swept(example: str, moments: int, pairs: bool = False, seed: int = 1) -> Sweep:
    prepared = kitrobot.open(EXAMPLES / example / f"{example}.krt").prepare(RunOptions(seed, 600.0))
    return run_sweep(prepared, SweepOptions(moments, pairs, None if THOROUGH else 1))


@pytest.mark.parametrize("seed", [1, 2, 3, 4] if THOROUGH else [1])
def test_all_boxes_arrive_whoever_fails_whenever(seed: int) -> None:
    sweep = swept("transport-team", 100 if THOROUGH else 3, seed=seed)
    assert sweep.holds
    assert sweep.counts["done"] == sweep.total == 11 * len(sweep.moments)
    assert all("B holds all 12 boxes" in field.sentence for field in sweep.fields)


def test_when_any_two_fail_all_boxes_arrive_or_the_team_says_who_is_missing() -> None:
    sweep = swept("transport-team", 20 if THOROUGH else 1, pairs=True)
    assert sweep.holds
    assert sweep.counts["stuck"] == sweep.counts["time"] == 0
    for field in sweep.fields:
        lost = {sweep.agents[fault.agent].rstrip("12") for fault in field.faults}
        assert (field.outcome == "done") or len(lost) == 1
        assert (field.outcome == "done") or "The team cannot go on: nobody is left of " in field.sentence


def test_searchers_that_are_left_search_all_rooms() -> None:
    sweep = swept("shared-search", 20 if THOROUGH else 2)
    late = [field for field in sweep.fields if field.faults[0].tick]
    assert {field.outcome for field in late} == {"done"}
