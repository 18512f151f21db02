"""What a new mission can begin with: every choice that fits opens without an error and moves; no other is given."""

from __future__ import annotations

from pathlib import Path

import pytest

from kitrobot.live.studio import Studio
from kitrobot.primitives.catalogue import SHIPPED
from kitrobot.wire.starter import robot_set_shape
from kitrobot.workspace.new_mission_choices import NOTHING, NoBeginningError, read_beginnings


@pytest.fixture(scope="module")
def studio(tmp_path_factory: pytest.TempPathFactory) -> Studio:
    return Studio(tmp_path_factory.mktemp("missions"), None)


def test_every_choice_that_fits_opens_without_an_error_and_has_no_title(studio: Studio) -> None:
    choices = studio.choices
    count = 0
    for kind in choices.robot_sets:
        assert choices.places_of(kind), kind.name
        for place in choices.places_of(kind):
            starters = choices.starters_of(kind, place)
            assert len(starters) >= 2, (kind.name, place)
            for starter in starters:
                opened = studio.open(choices.begin(kind.name, place, starter), "")
                assert [problem for problem in opened.report.problems if problem.is_error] == [], (
                    kind.name,
                    starter,
                )
                assert (opened.mission.label, opened.mission.help) == ({}, {})
                count += 1
    assert count > 20


def test_all_that_is_listed_is_there(studio: Studio) -> None:
    made, problems = read_beginnings(
        (Path(__file__).parents[2] / "src/kitrobot/workspace/shipped/beginnings.xml").read_bytes(), "beginnings.xml"
    )
    assert made is not None
    assert problems == []
    choices = studio.choices
    assert (len(choices.robot_sets), len(choices.places), len(choices.starters)) == (
        len(made.robot_sets),
        len(made.places),
        len(made.starters),
    )
    used = {starter.name for starter in made.starters}
    fitting = {
        name
        for kind in choices.robot_sets
        for place in choices.places_of(kind)
        for name in choices.starters_of(kind, place)
    }
    assert fitting == used | {NOTHING}


def test_a_robot_of_one_s_own_is_there_as_long_as_its_file_is_and_begins_without_parts(tmp_path: Path) -> None:
    studio = Studio(tmp_path, None)
    before = studio.choices.robot_sets
    text = (SHIPPED / "mini-robot.robot.xml").read_text(encoding="utf-8")
    file = tmp_path / "rover.robot.xml"
    file.write_text(text.replace('name="mini-robot"', 'name="rover"', 1), encoding="utf-8")
    (tmp_path / "broken.robot.xml").write_text("<robot name='x'><actuator", encoding="utf-8")
    choices = studio.choices
    assert choices.robot_sets[:-1] == before
    shape = robot_set_shape(choices.robot_sets[-1], choices, studio.catalogue(""))
    assert (shape.name, shape.robots, shape.own) == ("rover", ["rover"], True)
    assert not robot_set_shape(before[0], choices, studio.catalogue("")).own
    assert choices.starters_of(choices.robot_set("rover"), shape.places[0]) == [NOTHING]
    opened = studio.open(choices.begin("rover", shape.places[0], NOTHING), "")
    assert [problem for problem in opened.report.problems if problem.is_error] == []
    assert opened.mission.programs[0].target == "rover"
    file.unlink()
    assert studio.choices.robot_sets == before


@pytest.mark.parametrize(
    ("robot_set", "place", "starter"),
    [
        ("nobody", "empty.world.xml", NOTHING),
        ("microbit", "empty.world.xml", NOTHING),
        ("mini-robot", "../empty.world.xml", NOTHING),
        ("mini-robot", "empty.world.xml", "heart/heart.krt"),
        ("mini-robot", "empty.world.xml", "/etc/passwd"),
    ],
)
def test_what_does_not_fit_is_refused_with_a_way_out(studio: Studio, robot_set: str, place: str, starter: str) -> None:
    with pytest.raises(NoBeginningError, match="a new mission cannot begin with") as refused:
        studio.choices.begin(robot_set, place, starter)
    assert "File, New" in str(refused.value.help)


@pytest.mark.parametrize(
    "text",
    [
        '<beginnings version="1"><robots/></beginnings>',
        '<beginnings version="2"/>',
        '<beginnings version="1"><starter><for robots="a" mission="../../x.krt"/></starter></beginnings>',
        '<beginnings version="1"><place world="/etc/passwd"/></beginnings>',
        '<beginnings version="1"',
    ],
)
def test_a_list_with_a_mistake_is_told_with_its_place(text: str) -> None:
    made, problems = read_beginnings(text.encode(), "beginnings.xml")
    assert made is None
    assert problems[0].place is not None
    assert problems[0].place.line == 1
