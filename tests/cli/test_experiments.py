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
    some = kitrobot("sweep", mission[0], "--addresses", "radio", "fail-r").out.splitlines()
    assert [line.split()[0] for line in some] == ["radio.range", "radio.delay", "radio.loss", "fail-rate"]
    assert "did you mean radio.delay?" in kitrobot("sweep", mission[0], "--addresses", "radio.dlay").err


def test_values_are_compared_run_by_run_or_all_with_all(kitrobot, mission):
    _begin(kitrobot, mission, "--measure", "distance,done")
    paired = kitrobot("sweep", "table", "study", "--compare", mission[1]).out.splitlines()
    assert paired[0].split("  ")[-2:] == ["distance more than 30", "p"]
    assert paired[1].split()[:2] == ["60", "3"]
    assert paired[3:] == ["  0.95: Student's t interval of the differences", "  p: paired t test, p-values by Holm"]
    asked = ("--compare", mission[1], "--unpaired", "--measure", "distance", "--measure", "done")
    text = kitrobot("sweep", "table", "study", *asked).out
    assert "3 and 3" in text
    assert "Newcombe's score interval" in text
    distance, done = kitrobot("sweep", "table", "study", *asked, "--json").json
    assert (distance["first"], distance["other"], distance["pairs"], distance["other_runs"]) == (30, 60, None, 3)
    assert (done["estimate"], done["p_value"], done["test"]) == (0, 1, "Fisher's exact test, p-values by Holm")
    assert "did you mean distance?" in kitrobot("sweep", "table", "study", *asked[:-3], "distnce").err
    assert "does not vary" in kitrobot("sweep", "table", "study", "--compare", "fail-rate").err
    assert "table STUDY" in " ".join(kitrobot("sweep", "study", "--unpaired").err.replace("│", " ").split())


def _offered(line, monkeypatch, kitrobot, shell="bash"):
    """What a shell offers at the end of a line."""
    asked = {"_KITROBOT_COMPLETE": f"complete_{shell}", "COMP_WORDS": line, "COMP_CWORD": str(line.count(" "))}
    asked |= {"_TYPER_COMPLETE_ARGS": line, "_TYPER_COMPLETE_FISH_ACTION": "get-args"}
    with monkeypatch.context() as patched:
        for name, value in asked.items():
            patched.setenv(name, value)
        said = kitrobot()
    assert said.err == ""
    return said.out.split("\n")[:-1] if said.out.strip() else []


def test_a_shell_completes_addresses_with_values_to_begin_with(kitrobot, mission, monkeypatch):
    file, speed = mission
    assert _offered(f"kitrobot sweep {file} --vary {speed[:-1]}", monkeypatch, kitrobot) == [f"{speed}=25:75:12"]
    (told,) = _offered(f"kitrobot sweep {file} --vary fail-r", monkeypatch, kitrobot, "fish")
    assert told == "fail-rate=0:1:0.25\t0; a number from 0 to 1"
    _begin(kitrobot, mission)
    assert _offered("kitrobot sweep table study --compare ", monkeypatch, kitrobot) == [speed]


@pytest.mark.parametrize("line", ["none.krt --vary ", "broken.krt --vary ", "--vary ", "table none --compare "])
def test_where_there_is_nothing_to_read_a_shell_is_offered_nothing(kitrobot, here, monkeypatch, line):
    (here / "broken.krt").write_text("<krt")
    assert _offered(f"kitrobot sweep {line}", monkeypatch, kitrobot) == []


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
