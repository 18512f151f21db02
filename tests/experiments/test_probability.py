"""The probability of a property: against what is known, for any number of processes, broken off, and mistaken."""

from __future__ import annotations

import math
from typing import Any

import pytest

import kitrobot
from kitrobot import OpenMission, RunOptions
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.experiments.probability import Probability, ProbabilityOptions, find_probability
from tests.experiments.conftest import SURE

TRUTH = (1 - SURE) ** (2 / 60)
"""The probability that the counter does not fail before it has counted to two."""


def asked(opened: OpenMission, question: str = "done", seed: int = 1, **options: Any) -> Probability:
    prepared = opened.prepare(RunOptions(seed, 30.0, SURE))
    return find_probability(prepared, question, ProbabilityOptions(**{"jobs": 1, **options}))


def decided(found: Probability) -> dict[str, Any]:
    """Everything but the time that it took and the number of processes."""
    made = found.to_json()
    del made["timing"]
    return made


def test_the_interval_holds_what_is_known_and_is_as_precise_as_asked(counter: OpenMission) -> None:
    found = asked(counter, precision=0.1)
    assert found.complete
    assert found.interval is not None
    assert found.interval.low <= TRUTH <= found.interval.high
    assert found.interval.error <= 0.1
    assert found.looked_at == found.runs <= (found.planned_runs or 0) < found.hoeffding_runs == 185
    assert found.holds == round(found.interval.estimate * found.runs)


def test_the_result_does_not_depend_on_the_number_of_processes(counter: OpenMission) -> None:
    assert decided(asked(counter, precision=0.15)) == decided(asked(counter, precision=0.15, jobs=2))


def test_another_seed_gives_other_runs_and_each_is_an_ordinary_run(counter: OpenMission) -> None:
    found = asked(counter, precision=0.15)
    other = asked(counter, precision=0.15, seed=1001)
    assert [one.seed for one in found.counterexamples] != [one.seed for one in other.counterexamples]
    assert len(found.examples) == len(found.counterexamples) == 3
    for one in (*found.examples, *found.counterexamples):
        run = counter.run(seed=one.seed, seconds=30.0, fail_rate=SURE)
        assert (run.outcome == "done", run.ticks, run.sentence) == (one.holds, one.tick, one.sentence)


@pytest.mark.parametrize(("threshold", "decision"), [(0.7, True), (0.97, False)])
def test_at_least_is_decided_as_it_is_known(counter: OpenMission, threshold: float, decision: bool) -> None:
    found = asked(counter, at_least=threshold, precision=0.02)
    assert (found.decision, found.complete, found.interval) == (decision, True, None)
    assert found.method == f"Wald's sequential probability ratio test, {threshold} ± 0.02"


def test_too_few_runs_leave_at_least_open_and_an_estimate_imprecise(counter: OpenMission) -> None:
    found = asked(counter, at_least=0.8, precision=0.05, most_runs=3)
    assert (found.runs, found.decision, found.complete) == (3, None, False)
    found = asked(counter, precision=0.01, most_runs=12)
    assert (found.runs, found.complete) == (12, True)
    assert found.interval is not None
    assert found.interval.error > 0.01


@pytest.mark.parametrize("jobs", [1, 2])
def test_what_is_known_so_far_is_given_when_somebody_breaks_off(counter: OpenMission, jobs: int) -> None:
    runs: list[int] = []

    def progress(done: int, most: int | None) -> None:
        assert most is not None
        runs.append(done)
        if done == 60:
            raise KeyboardInterrupt

    prepared = counter.prepare(RunOptions(1, 30.0, SURE))
    options = ProbabilityOptions(0.12, 0.9, jobs=jobs)
    found = find_probability(prepared, "done", options, progress)
    assert runs == list(range(1, 61))
    assert (found.complete, found.runs) == (False, 60)
    assert found.interval is not None
    assert found.looked_at <= 60
    assert found.interval.low < TRUTH < found.interval.high


def test_whoever_asks_for_the_end_gets_what_is_known_so_far(counter: OpenMission) -> None:
    prepared = counter.prepare(RunOptions(1, 30.0, SURE))
    found = find_probability(prepared, "done", ProbabilityOptions(jobs=1), stop=lambda: True)
    assert (found.runs, found.interval, found.method) == (0, None, "none")
    assert found.to_json()["estimate"] is None


def test_python_asks_as_the_command_line_does(counter: OpenMission) -> None:
    told: list[int] = []
    found = kitrobot.probability(
        counter,
        "done within 5",
        fail_rate=SURE,
        precision=0.2,
        confidence=0.9,
        seed=5,
        jobs=1,
        progress=lambda done, _: told.append(done),
    )
    assert found.interval is not None
    assert (found.interval.confidence, found.seed, told[-1]) == (0.9, 5, found.runs)
    assert kitrobot.probability(counter, "done", at_least=0.5, precision=0.3, jobs=1).decision


@pytest.mark.parametrize(
    ("options", "sentence"),
    [
        ({"precision": 0.0}, "expected a precision"),
        ({"precision": math.nan}, "expected a precision"),
        ({"confidence": 1.0}, "expected a confidence"),
        ({"at_least": 1.0}, "expected a share between 0 and 1"),
        ({"at_least": 0.99, "precision": 0.05}, "cannot be told from"),
        ({"most_runs": 0}, "there is no run to count"),
        ({"jobs": 0}, "1 to 256 processes"),
        ({"jobs": 257}, "1 to 256 processes"),
    ],
)
def test_options_that_make_no_sense_are_errors(counter: OpenMission, options: dict[str, Any], sentence: str) -> None:
    with pytest.raises(KitRobotError, match=sentence):
        asked(counter, **options)
