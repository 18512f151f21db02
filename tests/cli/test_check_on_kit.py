"""`kitrobot check --board` of texts and of programs of teams, and what is said where no kit is named."""

from __future__ import annotations

import json
from pathlib import Path

from tests.verifier.check_fixtures import EXAMPLES

GOOD = "Wheel.Advance(40); WAIT(5); Wheel.Stop();"


def test_a_text_is_looked_at_with_its_robot(kitrobot, here: Path) -> None:
    (here / "go.lll").write_text(GOOD)
    said = kitrobot("check", "go.lll", "--robot", "mini-robot", "--board", "pico", "--json")
    (row,) = json.loads(said.out)
    used = {part["part"] for part in row["parts"] if part["used"]}
    assert (said.status, row["ok"], used) == (0, True, {"Wheel"})


def test_a_text_without_a_robot_is_told_to_name_one(kitrobot, here: Path) -> None:
    (here / "go.lll").write_text(GOOD)
    said = kitrobot("check", "go.lll", "--board", "pico")
    assert said.status == 1
    assert "--robot" in said.err
    assert "XML" not in said.err.partition("help")[0]


def test_a_text_with_an_error_says_which(kitrobot, here: Path) -> None:
    (here / "go.lll").write_text("Wheel.Advanse(40);")
    said = kitrobot("check", "go.lll", "--robot", "mini-robot", "--board", "pico")
    assert said.status == 1
    assert "Advanse" in said.err


def test_what_a_team_gives_a_robot_is_no_part_that_a_kit_could_lack(kitrobot) -> None:
    said = kitrobot("check", EXAMPLES / "transport-team" / "transport-team.krt", "--board", "pico", "--json")
    teams = [part for row in json.loads(said.out) for part in row["parts"] if part["part"] == "Team"]
    assert teams
    assert {(part["problem"], part["missing"]) for part in teams} == {("", False)}
    assert "driver ``" not in said.err


def test_a_robot_that_says_no_wiring_is_told_to_name_a_kit(kitrobot, here: Path) -> None:
    (here / "switch.lll").write_text("Switch.SwitchOn();")
    assert kitrobot("convert", "switch.lll", "switch.krt", "--robot", "mini-robot").status == 0
    for path, parts in ((EXAMPLES / "square" / "square.krt", "Motor, Wheel"), ("switch.krt", "Switch")):
        said = kitrobot("deploy", path, "--to", "socket://127.0.0.1:1")
        assert said.status == 1
        assert "--board" in said.err
        assert all(part in said.err for part in parts.split(", "))
        assert "the driver `turn` needs" not in said.err
