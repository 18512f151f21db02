"""Tabs, places and words of the palette, as XML says them: what is read, what is reported, what stays as it was."""

from __future__ import annotations

from pathlib import Path

import pytest

from kitrobot.diagnostics.model import Severity
from kitrobot.primitives.catalogue import Catalogue, load_catalogue
from kitrobot.primitives.constructors import Constructor
from kitrobot.primitives.constructors_xml import read_constructors
from kitrobot.primitives.own_xml import read_own, write_constructor
from kitrobot.primitives.palette_xml import LONGEST_WORD, MOST_WORDS
from kitrobot.primitives.robot import LAST_PLACE, Robot
from kitrobot.primitives.robot_xml import read_robot


def robot_xml(inside: str = "", actuator: str = "", procedure: str = "") -> str:
    return (
        f'<robot name="tiny" version="1"><actuator name="Wheel" device="drive" {actuator}>{inside}'
        f'<procedure name="Go" {procedure}/></actuator></robot>'
    )


def read(text: str) -> tuple[Robot, list[str]]:
    robot, problems = read_robot(text.encode(), "tiny.robot.xml")
    assert robot is not None
    assert all(problem.severity is Severity.WARNING for problem in problems)
    return robot, [str(problem.message) for problem in problems]


def test_words_are_read_by_language_with_either_comma_and_over_several_elements() -> None:
    words = '<word>go, move on</word><word>roll</word><word xml:lang="ur">جاؤ، چلو</word>'
    robot, problems = read(robot_xml(words))
    assert problems == []
    assert robot.actuators[0].words == {"": ("go", "move on", "roll"), "ur": ("جاؤ", "چلو")}
    assert robot.actuators[0].methods[0].words == {}


def test_a_word_is_as_long_as_it_may_be_and_a_longer_one_is_told_and_left_out() -> None:
    robot, problems = read(robot_xml(f"<word>{'a' * LONGEST_WORD}</word>"))
    assert problems == []
    assert robot.actuators[0].words[""] == ("a" * LONGEST_WORD,)
    robot, [problem] = read(robot_xml(f"<word>go, {'a' * (LONGEST_WORD + 1)}</word>"))
    assert problem.startswith("expected at most 30 characters in a word, found 31: ")
    assert robot.actuators[0].words[""] == ("go",)


def test_there_are_as_many_words_as_there_may_be_and_more_are_told_and_left_out() -> None:
    def many(count: int) -> str:
        return robot_xml(f"<word>{', '.join(f'w{number}' for number in range(count))}</word>")

    assert read(many(MOST_WORDS))[1] == []
    robot, problems = read(many(MOST_WORDS + 1))
    assert problems == ["expected at most 30 words in one language, found 31"]
    assert len(robot.actuators[0].words[""]) == MOST_WORDS


@pytest.mark.parametrize("text", ["", " ", "go,", "، go"])
def test_a_missing_word_is_told(text: str) -> None:
    assert read(robot_xml(f"<word>{text}</word>"))[1] == ["expected a word to find the part by in <word>, found none"]


def test_a_language_that_is_not_spoken_here_is_told() -> None:
    [problem] = read(robot_xml('<word xml:lang="tlh">jaH</word>'))[1]
    assert "nobody is shown this text" in problem


def test_place_and_group_change_nothing_that_an_image_depends_on() -> None:
    plain, _ = read(robot_xml())
    robot, problems = read(robot_xml("<word>go</word>", 'group="Move"', 'group="Draw" order="3"'))
    assert problems == []
    [wheel] = robot.actuators
    assert (wheel.group, wheel.methods[0].group, wheel.methods[0].order) == ("Move", "Draw", 3)
    assert (plain.actuators[0].group, plain.actuators[0].methods[0].order) == ("", LAST_PLACE)
    assert robot.fingerprint == plain.fingerprint
    assert wheel.settings == plain.actuators[0].settings


@pytest.mark.parametrize(("order", "is_right"), [(0, False), (1, True), (999, True), (1000, False)])
def test_a_place_has_its_limits(order: int, is_right: bool) -> None:
    _, problems = read_robot(robot_xml(procedure=f'order="{order}"').encode(), "tiny.robot.xml")
    assert (problems == []) is is_right


def catalogue(folder: Path, monkeypatch: pytest.MonkeyPatch, robot: str, constructors: str = "") -> Catalogue:
    monkeypatch.setenv("KITROBOT_CONFIG", str(folder / "none"))
    (folder / "tiny.robot.xml").write_text(robot, encoding="utf-8")
    if constructors:
        (folder / "tabs.xml").write_text(f'<constructors version="1">{constructors}</constructors>', encoding="utf-8")
    return load_catalogue([folder])


def test_a_tab_that_is_not_there_is_told_with_its_place_and_the_nearest_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for where in ({"actuator": 'group="Muve"'}, {"procedure": 'group="Muve"'}):
        made = catalogue(tmp_path, monkeypatch, robot_xml(**where))
        [problem] = made.problems
        assert problem.code == "palette-group"
        assert problem.message == "Wheel of tiny stands in the group “Muve”, which no constructors file has"
        assert str(problem.help) == "did you mean Move?"
        assert problem.place is not None
        assert problem.place.line == 1
        assert "tiny" in made.robots


def test_a_file_of_ones_own_adds_a_tab_and_changes_the_look_of_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    tabs = '<group name="Farm" colour="action" icon="tractor"/><group name="Move" colour="test" icon="tractor"/>'
    made = catalogue(tmp_path, monkeypatch, robot_xml(actuator='group="Farm"'), tabs)
    assert made.problems == []
    groups = {group.name: group for group in made.groups}
    assert groups["Farm"].icon == groups["Move"].icon == "tractor"
    assert groups["Move"].label["fr"] == "Bouger"
    assert next(iter(groups)) == "Move"


def test_a_tab_holds_parts_of_one_kind_and_of_no_other_kind() -> None:
    text = '<constructors version="1"><group name="G" colour="test" holds="{}"/></constructors>'
    [group], problems = read_constructors(text.format("sensors").encode(), "c.xml")
    assert problems == []
    assert group.holds == "sensors"
    _, [problem] = read_constructors(text.format("sensor").encode(), "c.xml")
    assert "did you mean sensors?" in str(problem.help)


def test_a_part_of_a_mission_keeps_its_place_and_its_words() -> None:
    lines = [
        '<constructor name="Nap" order="7">',
        "<word>sleep, rest</word>",
        '<word xml:lang="ur">سونا، آرام</word>',
        "<code>WAIT(5)</code></constructor>",
    ]
    made, problems = read_own(lines, "m.krt")
    assert problems == []
    assert isinstance(made, Constructor)
    assert (made.order, made.words["ur"]) == (7, ("سونا", "آرام"))
    assert read_own(write_constructor(made), "m.krt") == (made, [])


def test_what_a_robot_does_first_comes_first(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    made = catalogue(tmp_path, monkeypatch, robot_xml())
    tabs = ["Move", "Sense", "Draw", "Sound", "Actions", "Loops", "Choices", "Parallel", "Conditions"]
    assert [group.name for group in made.groups][: len(tabs)] == tabs
    assert all(group.icon for group in made.groups)
    robot = made.robots["mini-robot"]
    placed = {one.order: f"{part.name}.{one.name}" for part in robot.actuators for one in part.methods}
    first = ["Wheel.DriveBy", "Wheel.BackBy", "Motor.RightBy", "Motor.LeftBy"]
    assert [placed[place] for place in range(1, 5)] == first
