"""Previews: what is shown of a mission is its run, made once for each content, and those that ship need no run."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from kitrobot.live.studio import Studio
from kitrobot.translation.languages import TEXT_LANGUAGES
from kitrobot.workspace.example_list import EXAMPLES_XML, LEVELS, read_examples, shipped_examples
from kitrobot.workspace.mission_loader import OpenMission
from kitrobot.workspace.new_mission_choices import PREVIEW_S
from kitrobot.workspace.previews import (
    MOST_FRAMES,
    SHIPPED_PREVIEWS,
    Previews,
    make_preview,
    preview_from,
    preview_text,
    read_previews,
    shipped_previews,
)
from tools.previews import wanted


@pytest.fixture(scope="module")
def studio(tmp_path_factory: pytest.TempPathFactory) -> Studio:
    return Studio(tmp_path_factory.mktemp("missions"), None)


def opened(studio: Studio, path: str) -> OpenMission:
    data, _ = studio.folder.read(path)
    return studio.read(data, path, path)


def test_no_example_and_no_choice_of_a_new_mission_has_to_be_run(studio: Studio) -> None:
    previews = Previews()
    count = 0
    for mission, seconds, hands in wanted(studio):
        found = previews.of(mission, seconds, hands)
        assert found is not None, mission.name
        assert 2 <= found.frames <= MOST_FRAMES + 1
        # Whoever changed how things move makes them anew.
        assert found == make_preview(mission, seconds, hands), mission.name
        count += 1
    assert previews.runs == 0, "python -m tools.previews --write"
    assert len(shipped_previews()) <= count, "python -m tools.previews --write"
    assert SHIPPED_PREVIEWS.stat().st_size < 1_000_000


def test_a_square_is_driven_from_one_corner_to_the_next(studio: Studio) -> None:
    made = make_preview(opened(studio, "example:square/square.krt"), PREVIEW_S)
    [way] = made.ways
    assert len(way) == 5 * made.frames
    assert made.agents == [["robot-1", "square", "mini-robot", 1]]
    xs, ys = way[0::5], way[1::5]
    assert max(xs) - min(xs) > 100
    assert max(ys) - min(ys) > 100


def test_pens_displays_and_who_stands_still_are_told_in_few_numbers(studio: Studio) -> None:
    flower = make_preview(opened(studio, "example:flower/flower.krt"))
    assert flower.marks
    assert all(0 <= mark[0] < flower.frames for mark in flower.marks)
    assert flower.pens == [0]
    heart = make_preview(opened(studio, "example:heart/heart.krt"))
    assert [len(way) for way in heart.ways] == [5]
    assert len({tuple(numbers) for _, _, _, numbers in heart.shown}) >= 2
    dice = make_preview(
        opened(studio, "example:dice/dice.krt"), hands=shipped_examples().examples["dice/dice.krt"].hands
    )
    assert any(any(numbers) for _, _, part, numbers in dice.shown if part == "Display")


def test_one_content_is_run_once_and_another_one_again(studio: Studio) -> None:
    previews = Previews(shipped={})
    mission = opened(studio, "example:square/square.krt")
    first = previews.of(mission, 1.0)
    assert previews.of(opened(studio, "example:square/square.krt"), 1.0) is first
    assert previews.runs == 1
    assert previews.of(mission, 2.0) != first
    world = mission.world
    assert world is not None
    assert previews.of(replace(mission, world=replace(world, width_mm=world.width_mm + 1)), 1.0) is not first
    assert previews.runs == 3
    assert previews.of(replace(mission, world=None)) is None


def test_a_mission_that_cannot_run_has_none_and_is_not_tried_again(studio: Studio) -> None:
    mission = opened(studio, "example:square/square.krt")
    team = replace(mission.mission.team, agents=[replace(mission.mission.team.agents[0], start="nowhere")])
    broken = replace(mission, mission=replace(mission.mission, team=team))
    previews = Previews(shipped={})
    assert previews.of(broken) is None
    assert previews.of(broken) is None
    assert previews.runs == 1


def test_a_preview_survives_its_line_and_a_damaged_file_only_costs_a_run(studio: Studio, tmp_path: Path) -> None:
    mission = opened(studio, "example:square/square.krt")
    made = make_preview(mission, 1.0)
    assert preview_from(preview_text(made)) == made
    for text in ("", "{", "[]", '{"agents": []}', "null"):
        assert preview_from(text) is None
    file = tmp_path / "previews.jsonl"
    assert read_previews(file) == {}
    file.write_bytes(b"\xff\xfe")
    assert read_previews(file) == {}
    file.write_text("one\n\nkey {\n")
    assert read_previews(file) == {"key": "{"}
    assert Previews(shipped=dict.fromkeys(shipped_previews(), "{")).of(mission, 1.0) == made


def test_every_example_has_a_level_and_topics_in_each_language(studio: Studio) -> None:
    listed = shipped_examples()
    found = [entry for entry in studio.gallery.entries(studio) if entry.example is not None]
    assert {entry.path.removeprefix("example:") for entry in found} == set(listed.examples)
    for entry in found:
        assert entry.example is not None
        assert 1 <= entry.example.level <= LEVELS
        assert entry.example.topics
        assert entry.example.agents >= 1
        assert entry.example.robots
    assert {topic for one in listed.examples.values() for topic in one.topics} == {one.name for one in listed.topics}
    for topic in listed.topics:
        assert set(TEXT_LANGUAGES) == set(topic.label)


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ('<examples version="1"><topic/></examples>', 1),
        ('<examples version="2"/>', 1),
        ('<examples version="1">\n<example mission="../x.krt" level="1" topics=""/></examples>', 2),
        ('<examples version="1">\n<example mission="x.krt" level="4" topics=""/></examples>', 2),
        ('<examples version="1"><topic name="a"/>\n<example mission="x.krt" level="1" topics="b"/></examples>', 2),
        ('<examples version="1"', 1),
    ],
)
def test_a_list_of_examples_with_a_mistake_is_told_with_its_place(text: str, line: int) -> None:
    made, problems = read_examples(text.encode(), EXAMPLES_XML.name)
    assert made is None
    assert problems[0].place is not None
    assert problems[0].place.line == line
