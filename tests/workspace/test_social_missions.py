"""Missions whose agents run a program of the whole team: checked for each kind of robot, converted, run, replayed."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from kitrobot.mission.model import Agent
from kitrobot.mission.reader import read_mission
from kitrobot.mission.writer import write_mission
from kitrobot.versions.comparison import differences
from kitrobot.workspace.conversion import convert
from kitrobot.workspace.executables import load_executable
from kitrobot.workspace.replay import state_at
from kitrobot.workspace.traces import open_trace
from tests.workspace.social import opened, social_mission

TEXT = """role driver: mini-robot 1..2;
role lamp: microbit;
group both = {driver, lamp};

2*(
  SeqOfPar driver (
    Light.LightOn();
    WAIT(5);
    Light.LightOff();
  );
);
"""
AGENTS = {"a": "mini-robot", "b": "mini-robot", "c": "microbit"}


def test_a_program_of_the_whole_team_runs_and_is_recorded(tmp_path: Path) -> None:
    mission = opened(social_mission(TEXT, AGENTS), tmp_path)
    assert mission.check().problems == ()
    run = mission.run(trace=tmp_path / "a.krtrace")
    assert (run.outcome, run.sentence) == ("done", f"Done after {run.seconds:.1f} s: every program has ended.")
    trace = open_trace(tmp_path / "a.krtrace")
    seen = {
        one["element"]
        for tick in range(run.ticks)
        for one in state_at(trace, tick * trace.reader.header.tick_ms / 1000)["agents"]["a"]["vertices"]
    }
    trace.reader.close()
    assert {"Repetition", "SeqOfPar", "Wait"} <= seen


def test_work_is_shared_out_between_kinds_of_robots(tmp_path: Path) -> None:
    text = """role driver: mini-robot 2;
role lamp: microbit;
group both = {driver, lamp};
work Boxes = 5;

ParOfSeq both (
  *[!(Boxes.IsEmpty())](
    Boxes.Take();
    WAIT(5);
    Boxes.Done();
  );
);
"""
    mission = opened(social_mission(text, AGENTS), tmp_path)
    assert mission.check().problems == ()
    simulation = mission.simulation()
    while simulation.outcome is None:
        simulation.advance(100)
    assert simulation.outcome == "done"
    assert list(simulation.state.team.works[0]) == [0]


def test_a_kind_of_robot_has_its_own_program(tmp_path: Path) -> None:
    opened(social_mission(TEXT, AGENTS), tmp_path)
    for robot in ("mini-robot", "microbit"):
        assert convert(tmp_path / "team.krt", tmp_path / f"{robot}.lll", robot=robot).written
        assert convert(tmp_path / "team.krt", tmp_path / f"{robot}.kri", robot=robot).written
    assert "Light.LightOn();" in (tmp_path / "mini-robot.lll").read_text()
    assert (tmp_path / "microbit.lll").read_text() == (
        "Team.Join();\nTeam.Ask(0, 0);\n*[Team.Answer()](\n  Team.Meet(5);\n  Team.Ask(0, 1);\n);\n"
    )
    loaded = load_executable(tmp_path / "team.krt", robot="microbit")
    assert loaded.image is not None
    assert loaded.diagnostics == ()


def test_what_a_kind_of_robot_cannot_do_is_told_at_its_vertex(tmp_path: Path) -> None:
    text = TEXT.replace("SeqOfPar driver", "SeqOfPar both")
    problems = [one for one in opened(social_mission(text, AGENTS), tmp_path).check().problems if one.is_error]
    assert {(one.code, one.program) for one in problems} == {("unknown-object", "team")}
    assert {one.message for one in problems} == {"the robot `microbit` has no `Light`"}
    lines = (tmp_path / "team.krt").read_text().splitlines()
    assert all(one.place is not None and "Light.Light" in lines[one.place.line - 1] for one in problems)


@pytest.mark.parametrize(
    ("agent", "code"),
    [
        (Agent("a", "team", "", ""), "mission-agent-robot"),
        (Agent("a", "team", "", "nobody"), "mission-no-robot"),
    ],
)
def test_who_runs_a_program_of_the_whole_team_says_which_robot_it_is(tmp_path: Path, agent: Agent, code: str) -> None:
    mission = social_mission(TEXT, AGENTS)
    mission.team.agents[0] = agent
    problems = [one for one in opened(mission, tmp_path).check().problems if one.is_error]
    assert [one.code for one in problems] == [code]
    assert problems[0].place is not None
    assert 'name="a"' in (tmp_path / "team.krt").read_text().splitlines()[problems[0].place.line - 1]


def test_too_few_robots_for_a_role_are_told(tmp_path: Path) -> None:
    text = "role driver: mini-robot 2;\nrole other: mini-robot;\n\nParOfSeq driver (\n  WAIT(1);\n);\n"
    problems = opened(social_mission(text, {"a": "mini-robot", "b": "mini-robot"}), tmp_path).check().problems
    assert [one.code for one in problems if one.is_error] == ["run-role"]


def test_the_kind_of_an_agent_is_written_read_and_compared() -> None:
    mission = social_mission(TEXT, AGENTS)
    again, problems = read_mission(write_mission(mission), "team.krt")
    assert problems == []
    assert again == mission
    other, _ = read_mission(write_mission(mission), "team.krt")
    assert other is not None
    other.team.agents[0] = replace(other.team.agents[0], robot="microbit")
    assert [one.words for one in differences(mission, other)] == ["the team: the robot of a: mini-robot → microbit"]
