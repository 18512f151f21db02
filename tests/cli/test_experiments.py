"""`kitrobot sweep`: from a plan to rows and tables, and what it says when something is wrong."""

from __future__ import annotations

import pytest

from kitrobot.mission.writer import save
from tests.experiments.missions import short_mission, speed_address


@pytest.fixture
def mission(here):
    """A file of a short mission, and the address of its speed."""
    opened = short_mission()
    save(here / "short.krt", opened.mission)
    return here / "short.krt", speed_address(opened)


def _begin(kitrobot, mission, *more):
    file, speed = mission
    return kitrobot("sweep", file, "--vary", f"{speed}=30,60", "--seeds", "1-3", "--jobs", 1, "-o", "study", *more)


def test_a_study_is_begun_looked_at_and_given_as_a_table(kitrobot, mission):
    said = _begin(kitrobot, mission)
    assert (said.status, said.out, said.err) == (0, "study: 6 of 6 runs\n  done  6\n", "")
    table = kitrobot("sweep", "table", "study", "--csv").out.splitlines()
    assert table[0].startswith(f"row,id,seed,{mission[1]},outcome,sentence,seconds,done,delivered,collisions")
    assert len(table) == 7
    assert kitrobot("sweep", "study", "--status", "--json").json == {"done": 6, "total": 6, "outcomes": {"done": 6}}
    assert _begin(kitrobot, mission).out == said.out
    assert kitrobot("sweep", "study", "--resume", "--jobs", 1).out == said.out


def test_the_run_of_a_row_is_recorded(kitrobot, mission, here):
    _begin(kitrobot, mission)
    said = kitrobot("sweep", "study", "--trace", 4, "-o", "row.krtrace")
    assert (said.status, said.out) == (0, "row.krtrace\n")
    assert kitrobot("replay", "row.krtrace").status == 0


def test_shards_are_merged(kitrobot, mission):
    for number, folder in ((1, "one"), (2, "two")):
        said = _begin(kitrobot, mission, "--shard", f"{number}/2", "-o", folder)
        assert said.out.startswith(f"{folder}: 3 of 6 runs")
    assert kitrobot("sweep", "merge", "one", "two", "-o", "whole").out.startswith("whole: 6 of 6 runs")


def test_all_that_can_vary_is_listed(kitrobot, mission):
    lines = kitrobot("sweep", mission[0], "--addresses").out.splitlines()
    assert any(line.startswith(mission[1]) and "a whole number from 0 to 100" in line for line in lines)
    told = kitrobot("sweep", mission[0], "--addresses", "--json").json
    assert {"address": "fail-rate", "now": 0, "expected": "a number from 0 to 1"} in told


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("--vary", "drive.x.speed=1"), "no `drive.x.speed` that could vary"),
        (("--vary", "agents.drve=1..2"), "did you mean agents.drive?"),
        (("--vary", "agents.drive=-1"), "expected a whole number from 0 to 10000, found `-1`"),
        (("--vary", "agents.drive"), "expected ADDRESS=VALUES"),
        (("--vary", "agents.drive=1..2", "--vary", "fail-rate=0", "--zip"), "these have 2, 1"),
        (("--measure", "sconds"), "did you mean seconds?"),
        (("--measure", "time nobody"), "the measure `time nobody`"),
        (("--seeds", "5-1"), "expected seeds such as 1-1000"),
        (("--shard", "3"), "expected a shard such as 3/64"),
        (("--fail-rate", "nan"), "a probability from 0 to 1"),
        (("--points", "none.csv"), "none.csv"),
        (("--vary", "program.drive=none.lll"), "none.lll"),
    ],
)
def test_a_mistake_is_one_sentence(kitrobot, mission, arguments, words):
    said = kitrobot("sweep", mission[0], "--jobs", 1, *arguments)
    assert said.status == 1
    assert words in said.err
    assert "Traceback" not in said.err


def test_a_folder_that_is_no_study_and_another_study_are_refused(kitrobot, mission, here):
    assert "holds no study" in kitrobot("sweep", here, "--resume").err
    assert "holds no study" in kitrobot("sweep", "table", here).err
    _begin(kitrobot, mission)
    assert "`study` holds another study" in _begin(kitrobot, mission, "--seeds", "1-4").err
    said = kitrobot("sweep", "study", "--vary", "fail-rate=0,1")
    assert said.status == 2
    assert "another one is another folder" in said.err


def test_programs_are_tried_against_each_other(kitrobot, mission, here):
    (here / "fast.lll").write_text("Wheel.Advance(100); WAIT(5); Wheel.Stop();")
    (here / "slow.lll").write_text("Wheel.Advance(10); WAIT(50); Wheel.Stop();")
    (here / "wrong.lll").write_text("Wheel.Fly(1);")
    vary = "program.drive=fast.lll,slow.lll,wrong.lll"
    said = kitrobot("sweep", mission[0], "--vary", vary, "--jobs", 1, "-o", "study")
    assert said.out == "study: 3 of 3 runs\n  done   2\n  error  1\n"
    assert "0.54" in (table := kitrobot("sweep", "table", "study").out) or "0.5" in table
