"""What becomes of robots that fail on a road, in the `.krt`: read, written, compared, merged, sent to the page."""

from __future__ import annotations

from dataclasses import replace

import pytest

from kitrobot.mission.breakdown import Breakdown, BreakdownRule
from kitrobot.mission.model import Mission
from kitrobot.mission.reader import read_mission
from kitrobot.mission.writer import write_mission
from kitrobot.versions.comparison import differences
from kitrobot.versions.mission_merge import merge_missions
from kitrobot.wire.mission import MissionShape, mission_from_shape, mission_shape

TOW = Breakdown(BreakdownRule.TOW, 2.5)
PASS = Breakdown(BreakdownRule.PASS)


def read(inside: str) -> tuple[Breakdown, list[tuple[str, str, str]]]:
    """What a mission says, and what is wrong: code, sentence and way out."""
    mission, problems = read_mission(f'<kitrobot version="1">{inside}</kitrobot>'.encode(), "m.krt")
    assert mission is not None
    return mission.breakdown, [(one.code, one.message, one.help) for one in problems]


@pytest.mark.parametrize("breakdown", [Breakdown(), TOW, Breakdown(BreakdownRule.TOW), PASS])
def test_what_is_written_is_read_and_travels_to_the_page_and_back(breakdown: Breakdown) -> None:
    mission = Mission(breakdown=breakdown)
    data = write_mission(mission)
    assert (b"breakdown" in data) == (breakdown != Breakdown())
    assert read_mission(data, "m.krt") == (mission, [])
    shape = MissionShape.model_validate_json(mission_shape(mission).model_dump_json())
    assert mission_from_shape(shape) == mission


def test_without_it_a_robot_stays() -> None:
    assert read("") == (Breakdown(), [])
    assert read('<breakdown rule="stay"/>') == (Breakdown(), [])


def test_seconds_are_kept_to_the_thousandth() -> None:
    assert read('<breakdown rule="tow" after="1.23456"/>') == (Breakdown(BreakdownRule.TOW, 1.235), [])


@pytest.mark.parametrize(
    ("inside", "code"),
    [
        ("<breakdown/>", "xml-missing"),
        ('<breakdown rule="fly"/>', "xml-bad-value"),
        ('<breakdown rule="tow" after="-1"/>', "xml-bad-value"),
        ('<breakdown rule="tow" after="1000000.5"/>', "xml-bad-value"),
        ('<breakdown rule="tow" after="nan"/>', "xml-bad-value"),
        ('<breakdown rule="pass" after="3"/>', "mission-breakdown"),
    ],
)
def test_what_makes_no_sense_is_told_and_a_robot_stays(inside: str, code: str) -> None:
    found, problems = read(inside)
    assert found == Breakdown()
    assert [one[0] for one in problems] == [code]


def test_a_second_one_is_told_and_the_first_one_counts() -> None:
    found, problems = read('<breakdown rule="tow" after="2.5"/><breakdown rule="pass"/>')
    assert found == TOW
    assert problems == [
        (
            "mission-breakdown",
            "this mission has said already what becomes of robots that fail on a road",
            "take one away",
        )
    ]


def test_a_difference_is_said_in_words() -> None:
    words = [one.sentence for one in differences(Mission(breakdown=TOW), Mission(breakdown=PASS))]
    assert words == ["robots that fail on a road: towed after 2.5 s → others drive round them"]
    assert differences(Mission(breakdown=TOW), Mission(breakdown=TOW)) == []


def test_a_merge_takes_the_side_that_changed_it_and_names_a_conflict() -> None:
    base, ours, theirs = Mission(), replace(Mission(), world_href="ring.world.xml"), Mission(breakdown=TOW)
    merged = merge_missions(base, ours, theirs)
    assert (merged.mission.breakdown, merged.mission.world_href) == (TOW, "ring.world.xml")
    both = merge_missions(base, Mission(breakdown=PASS), theirs)
    assert both.mission.breakdown == PASS
    assert any("breakdown" in one for one in both.conflicts)
