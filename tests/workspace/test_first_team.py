"""The first program of a whole team: each robot goes on doing what it did, in a role."""

from __future__ import annotations

import shutil
from dataclasses import replace
from pathlib import Path

import pytest

from kitrobot.lll.tree import RoleDeclaration
from kitrobot.mission.model import Agent, Mission
from kitrobot.mission.writer import write_mission
from kitrobot.workspace.first_team import TeamThereError, first_team
from kitrobot.workspace.mission_loader import OpenMission, open_mission

EXAMPLES = Path(__file__).parents[2] / "examples"


def made(folder: Path, example: str, name: str = "team") -> tuple[OpenMission, Mission]:
    shutil.copytree((EXAMPLES / example).parent, folder, dirs_exist_ok=True)
    opened = open_mission(folder / Path(example).name)
    return opened, first_team(opened, name)


def reopened(mission: Mission, folder: Path) -> OpenMission:
    (folder / "team.krt").write_bytes(write_mission(mission))
    return open_mission(folder / "team.krt")


def test_a_team_does_the_same_job_as_its_robots_did_alone(tmp_path: Path) -> None:
    _, mission = made(tmp_path, "transport/transport.krt")
    opened = reopened(mission, tmp_path)
    assert opened.check().problems == ()
    run = opened.run(seconds=300)
    assert (run.outcome, "B holds all 12 boxes" in run.sentence) == ("done", True)
    assert [(role.name, role.robot, role.least) for role in mission.team.roles][:2] == [
        ("carrier", "carrier", 3),
        ("loader", "loader", 1),
    ]


def test_names_that_are_taken_get_a_number(tmp_path: Path) -> None:
    opened, _ = made(tmp_path, "square/square.krt")
    opened.mission.team.roles.append(RoleDeclaration("square", "mini-robot", 0, 1))
    mission = first_team(opened, "square")
    assert [program.name for program in mission.programs] == ["square", "square-2"]
    assert [role.name for role in mission.team.roles] == ["square", "square-2"]


def test_who_runs_nothing_that_is_known_stays_as_it_is(tmp_path: Path) -> None:
    opened, _ = made(tmp_path, "square/square.krt")
    opened.mission.team.agents.append(Agent("lost", "nowhere"))
    mission = first_team(opened, "team")
    assert mission.team.agents[-1] == Agent("lost", "nowhere")


def test_robots_of_one_kind_get_the_roles_of_their_programs(tmp_path: Path) -> None:
    opened, _ = made(tmp_path, "square/square.krt")
    before = opened.mission
    before.programs.append(replace(before.programs[0], name="other"))
    square = before.programs[0].name
    before.team.agents[:] = [Agent("a", "other"), Agent("b", square), Agent("c", "other")]
    mission = first_team(opened, "team")
    assert [agent.name for agent in mission.team.agents] == ["b", "a", "c"]
    assert [(role.name, role.most) for role in mission.team.roles] == [(square, 1), ("other", 2)]


def test_a_mission_has_one_such_program(tmp_path: Path) -> None:
    shutil.copytree(EXAMPLES / "convoy", tmp_path, dirs_exist_ok=True)
    with pytest.raises(TeamThereError) as told:
        first_team(open_mission(tmp_path / "convoy.krt"), "team")
    assert told.value.message == "the mission has a program of the whole team already"


def test_a_check_says_what_the_team_s_program_is_for_each_kind_of_robot(tmp_path: Path) -> None:
    shutil.copytree(EXAMPLES / "convoy", tmp_path, dirs_exist_ok=True)
    [projection] = open_mission(tmp_path / "convoy.krt").check().projections
    assert projection.robot == "mini-robot"
    said = {projection.lll[one.start : one.end]: (one.program, one.vertex, one.line) for one in projection.spans}
    assert said["Wheel.Advance(60)"] == ("convoy", "v4", 8)
    assert said["Team.Meet(3)"] == ("convoy", "v4", 9)
    assert open_mission(EXAMPLES / "square" / "square.krt").check().projections == ()
