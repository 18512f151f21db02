"""Mutants of shipped missions: they are missions with one mistake, and no two judges disagree on them."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from itertools import islice
from pathlib import Path

import pytest

from benchmarks.judge_comparison import Comparison, ComparisonOptions, compare, run_disagreements
from benchmarks.mutants import EXAMPLES, UNCHANGED, MutatedMission, found_by, judge_mutant, main, table
from benchmarks.mutation import Operator, mutants
from kitrobot.judges.judgement import Judge, JudgeAnswer, Judgement
from kitrobot.text.sentences import Sentence
from kitrobot.workspace.mission_loader import open_mission
from tests.effort import cases

SAMPLE = (
    "blink/blink.krt",
    "faster/faster.krt",
    "square/square.krt",
    "tutorials/draw/draw.krt",
    "tutorials/take-turns/take-turns.krt",
)


def test_mutants_have_one_mistake_each_and_come_again_with_the_same_seed() -> None:
    opened = open_mission(EXAMPLES / "transport/transport.krt")
    made = list(islice(mutants(opened, 1), 10))
    assert {one.operator for one in made} == set(Operator)
    assert len({one.change for one in made}) == len(made)
    assert [one.change for one in islice(mutants(opened, 1), 10)] == [one.change for one in made]
    assert [one.change for one in islice(mutants(opened, 2), 10)] != [one.change for one in made]
    for one in made:
        assert one.opened.report.ok
        before = {name: found.image for name, found in opened.images.items()}
        assert {name.program for name, found in one.opened.images.items() if found.image != before[name]} == {
            one.program
        }


@pytest.mark.parametrize("name", SAMPLE)
def test_no_two_judges_disagree_on_a_mission_and_its_mutants(name: str, tmp_path: Path) -> None:
    mission = MutatedMission(name, 1)
    for number in cases((UNCHANGED, 0, 1), range(2, 40)):
        # No clock decides what a check says.
        options = ComparisonOptions(mission.seconds, 2_000, 1000.0, moments=1, dear=1)
        row = judge_mutant(mission, number, tmp_path, options)
        if row is not None:
            assert [one for one in row["disagreements"] if not one["known"]] == [], (number, row["change"])


def test_a_recording_that_says_another_thing_than_its_run_is_a_disagreement(tmp_path: Path) -> None:
    opened = open_mission(EXAMPLES / "pair/pair.krt")
    made: Comparison = compare(opened, ["done within 60"], tmp_path, ComparisonOptions(6.0, moments=1, dear=1))
    assert made.disagreements == []
    for judge, ruling in ((Judge.RUN, JudgeAnswer.BROKEN), (Judge.TEAM, JudgeAnswer.NOT_DECIDED)):
        was = made.said[judge]["deadlock"]
        made.said[judge]["deadlock"] = replace(was, ruling=ruling)
        [found] = run_disagreements(made)
        assert found.question == "deadlock"
        made.said[judge]["deadlock"] = was


@pytest.mark.parametrize(("outcome", "faults"), [("stuck", 0), ("time", 0), ("done", 1)])
def test_a_recording_need_not_decide_what_it_does_not_hold(outcome: str, faults: int) -> None:
    run = Judgement(Judge.RUN, "", "served-a", Sentence("a is served"), JudgeAnswer.BROKEN, Sentence("waits"), 5)
    recording = replace(run, judge=Judge.RECORDING, ruling=JudgeAnswer.NOT_DECIDED, tick=-1)
    said = {Judge.RUN: run, Judge.RECORDING: recording, Judge.TEAM: replace(recording, judge=Judge.TEAM)}
    made = Comparison({judge: {"served-a": one} for judge, one in said.items()} | {Judge.RUNS: {}}, outcome=outcome)
    assert len(list(run_disagreements(made))) == faults


def test_a_judge_finds_what_it_did_not_say_of_the_mission_unchanged(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    head = {"mission": "a.krt", "operator": "", "change": "", "disagreements": []}
    unchanged = head | {
        "number": UNCHANGED,
        "said": {"run": {"done": "kept", "end": "broken"}, "check": {"end": "kept"}},
    }
    worse = head | {"number": 0, "operator": "swap", "said": {"run": {"done": "broken"}, "check": {"end": "broken"}}}
    same = head | {"number": 1, "operator": "drop", "said": {"run": {"done": "kept", "end": "broken"}, "check": {}}}
    assert found_by(worse, unchanged) == {"run", "check"}
    assert found_by(same, unchanged) == set()
    lines = {line[:12].strip(): line[12:].split() for line in table([unchanged, worse, same]).splitlines()}
    assert lines["operator"][:4] == ["mutants", "anybody", "check", "run"]
    assert Counter(lines["swap"][:4]) == Counter("1111")
    assert lines["drop"][:4] == ["1", "0", "0", "0"]
    assert lines["all"][:4] == ["2", "1", "1", "1"]
    assert main([str(tmp_path / "none.jsonl"), "--count", "0"]) == 0
    assert "0 disagreements, and 0 that are known" in capsys.readouterr().out
