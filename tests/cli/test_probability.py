"""`kitrobot probability`: what it says, its status, and bad input."""

from __future__ import annotations

import pytest

from kitrobot.experiments.run_question import RunJudge
from tests.cli.conftest import EXAMPLE

SQUARE = EXAMPLE.parents[1] / "square" / "square.krt"
"""Ends after 11.1 s; of its one robot half fail within a minute."""
ASKED = ("probability", SQUARE, "done within 20", "--jobs", 1)
FAILING = ("--fail-rate", 0.9)


def test_the_answer_says_its_interval_its_method_and_the_runs_that_differ(kitrobot):
    said = kitrobot(*ASKED, *FAILING, "--precision", 0.2)
    assert (said.status, said.err) == (0, "")
    lines = said.out.splitlines()
    assert lines[0] == "a run ends with the outcome done, within 20 s"
    rows = {line[:15].strip(): line[15:] for line in lines[2:7]}
    assert rows["probability"].startswith("0.")
    assert "between 0." in rows["probability"]
    assert rows["probability"].endswith("with a confidence of 95 %")
    assert rows["method"] == "Clopper and Pearson's exact interval at planned looks"
    assert rows["runs"].startswith("38, with the seeds 1 to 38; it holds in ")
    assert rows["planned"] == "at most 38 runs; a fixed number takes 47 (Chernoff-Hoeffding)"
    at = lines.index("  the first runs in which it does not hold:")
    assert len(lines[at + 1 :]) == 3
    assert all("failed after" in line for line in lines[at + 1 :])


def test_json_has_all_of_it_and_a_run_can_be_looked_at_by_its_seed(kitrobot):
    said = kitrobot(*ASKED, *FAILING, "--precision", 0.3, "--seed", 7, "--json").json
    assert (said["seed"], said["precision"], said["confidence"], said["complete"]) == (7, 0.3, 0.95, True)
    assert said["low"] < said["estimate"] < said["high"]
    assert said["estimate"] == said["holds"] / said["runs"]
    assert said["chernoff_hoeffding_runs"] == 21
    one = said["counterexamples"][0]
    run = kitrobot("run", SQUARE, "--seed", one["seed"], *FAILING, "--seconds", 20, "--json").json
    assert (run["sentence"], run["seconds"]) == (one["sentence"], one["seconds"])


@pytest.mark.parametrize(
    ("more", "status", "answer"),
    [
        (("--at-least", 0.5, "--precision", 0.3), 0, "yes, with a confidence of 95 %"),
        (("--at-least", 0.9, "--precision", 0.08, *FAILING), 1, "no, with a confidence of 95 %"),
        (("--at-least", 0.9, "--precision", 0.05, "--runs", 2), 3, "not decided"),
    ],
)
def test_at_least_is_answered_by_the_status_too(kitrobot, more, status, answer):
    said = kitrobot(*ASKED, *more)
    assert (said.status, said.err) == (status, "")
    assert answer in said.out
    assert "Wald's sequential probability ratio test" in said.out


@pytest.mark.parametrize(
    ("number", "known"), [(60, "between 0."), (3, "between 0."), (0, "not known: no run has ended")]
)
def test_ctrl_c_says_what_is_known_so_far(kitrobot, monkeypatch, number, known):
    answered, runs = RunJudge.answer, []

    def answer(judge, *arguments):
        runs.append(1)
        if len(runs) > number:
            raise KeyboardInterrupt
        return answered(judge, *arguments)

    monkeypatch.setattr(RunJudge, "answer", answer)
    said = kitrobot(*ASKED, *FAILING, "--precision", 0.12, "--confidence", 0.9)
    assert said.status == 130
    assert said.err == f"broken off after {number} runs\n"
    assert known in said.out
    assert ("with the seeds" in said.out) is (number > 0)


@pytest.mark.parametrize(
    ("arguments", "status", "sentence"),
    [
        ((SQUARE, "delivred"), 1, "this mission has no property delivred"),
        ((SQUARE, ""), 1, "there is no question"),
        ((SQUARE, "done within never"), 1, "expected seconds behind within"),
        ((SQUARE, "never any robot-9 (Count.IsTrue())"), 1, "`robot-9` is no agent of this team"),
        ((SQUARE, "done", "--precision", "nan"), 1, "expected a precision"),
        ((SQUARE, "done", "--precision", "0.7"), 1, "expected a precision"),
        ((SQUARE, "done", "--confidence", "95"), 1, "expected a confidence between 0 and 1"),
        ((SQUARE, "done", "--at-least", "1"), 1, "`kitrobot verify` may"),
        ((SQUARE, "done", "--runs", "0"), 2, "--runs"),
        ((SQUARE, "done", "--jobs", "1000"), 1, "1 to 256 processes"),
        ((SQUARE, "done", "--seconds", "inf"), 2, "a run takes more than 0"),
        ((SQUARE, "done", "--fail-rate", "nan"), 2, "from 0 to 1"),
        ((SQUARE, "done", "--seed", "-1"), 2, "--seed"),
        ((SQUARE,), 2, "PROPERTY"),
        (("nothing.krt", "done"), 1, "nothing.krt"),
    ],
)
def test_bad_input_is_a_sentence(kitrobot, arguments, status, sentence):
    said = kitrobot("probability", *arguments)
    assert (said.status, said.out) == (status, "")
    assert sentence in " ".join(said.err.split())
    assert "Traceback" not in said.err


@pytest.mark.parametrize(
    ("question", "rate", "advice"),
    [("failed", 0.001, "it holds in 0 of 56 runs: `--splitting failed`"), ("stuck", 0, ""), ("done", 0.001, "")],
)
def test_where_hardly_any_run_has_it_the_answer_names_the_count_to_split_at(kitrobot, question, rate, advice):
    asked = ("probability", SQUARE, question, "--fail-rate", rate, "--precision", 0.1, "--jobs", 1)
    said = kitrobot(*asked)
    assert (said.status, advice in said.out, "--splitting" in said.out) == (0, True, bool(advice))
    assert kitrobot(*asked, "--json").json["rare"] is (question != "done")


SPLIT = ("--fail-rate", 0.999, "--seconds", 1.2, "--splitting", "failed", "--runs", 400, "--jobs", 1)


def test_runs_are_split_where_one_more_fails_and_what_no_branch_finds_is_not_known(kitrobot):
    said = kitrobot("probability", EXAMPLE, "done", *SPLIT)
    lines = said.out.splitlines()
    assert (said.status, said.err) == (3, "")
    assert lines[0] == "a run ends with the outcome done"
    assert lines[2] == "  probability  not known: 0 of 10 repetitions found it; let there be more `--runs`"
    assert lines[3].startswith("  levels       failed: ")
    assert lines[4].endswith(" in 10 repetitions, with the seed 1")


def test_split_runs_are_json_too(kitrobot):
    said = kitrobot("probability", EXAMPLE, "time", *SPLIT, "--json")
    found = said.json
    assert (said.status, found["splitting"], found["complete"]) == (0, "failed", True)
    assert found["low"] < found["estimate"] < found["high"]
    assert len(found["repetitions"]) == 10


@pytest.mark.parametrize(
    ("more", "status", "sentence"),
    [
        (("--splitting", "speed"), 1, "runs are split at"),
        (("--splitting", "failed", "--at-least", 0.5), 2, "split runs give an estimate, no decision"),
        (("--splitting", "failed", "--runs", 5), 1, "5 branches are too few"),
    ],
)
def test_runs_that_cannot_be_split_are_a_sentence(kitrobot, more, status, sentence):
    said = kitrobot(*ASKED, *more)
    assert (said.status, said.out) == (status, "")
    assert sentence in said.err
