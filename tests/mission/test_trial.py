"""Breakpoints and failures on schedule: in the file, compared, merged, on the wire."""

from __future__ import annotations

import pytest

from kitrobot.mission.model import Mission
from kitrobot.mission.reader import read_mission
from kitrobot.mission.trial import Breakpoint, Failure, FailureKind
from kitrobot.mission.writer import write_mission
from kitrobot.versions.comparison import differences
from kitrobot.versions.mission_merge import merge_missions
from kitrobot.wire.mission import MissionShape, mission_from_shape, mission_shape

HEAD = """<kitrobot version="1"><program name="p" robot="mini-robot"><vertex id="start" element="Start"/>
<vertex id="stop" element="Stop"/><arc from="start" to="stop"/></program>
<team><agent name="a b" program="p"/><agent name="c" program="p"/></team>"""
PLAIN = '<breakpoint program="p" vertex="v1"/>'
FULL = """<breakpoint program="p" vertex="v2" every="yes" when="Count.GreaterThan(3)" hits="4" off="yes">
<agent name="a b"/><agent name="c"/></breakpoint>"""
FAILS = '<failure agent="c" at="12.5"/><failure agent="a b" at="0" kind="mute"/>'


def read(*parts: str) -> tuple[Mission, list[str]]:
    mission, problems = read_mission("\n".join((HEAD, *parts, "</kitrobot>")).encode(), "m.krt")
    assert mission is not None
    return mission, [item.message for item in problems]


def test_they_are_read_and_written_the_same() -> None:
    mission, problems = read(PLAIN, FULL, FAILS)
    assert problems == []
    assert mission.breakpoints == [
        Breakpoint("p", "v1"),
        Breakpoint("p", "v2", ("a b", "c"), True, "Count.GreaterThan(3)", 4, False),
    ]
    assert mission.failures == [Failure("c", 12.5), Failure("a b", 0.0, FailureKind.MUTE)]
    written = write_mission(mission)
    assert read_mission(written, "m.krt") == (mission, [])
    assert '  <breakpoint program="p" vertex="v1"/>' in written.decode().splitlines()
    assert '  <failure agent="c" at="12.5" kind="fail"/>' in written.decode().splitlines()


@pytest.mark.parametrize(
    "wrong",
    [
        '<breakpoint vertex="v1"/>',
        '<breakpoint program="p"/>',
        '<breakpoint program="p" vertex="v1" hits="0"/>',
        '<breakpoint program="p" vertex="v1" hits="many"/>',
        '<breakpoint program="p" vertex="v1" every="maybe"/>',
        '<breakpoint program="p" vertex="v1"><agent/></breakpoint>',
        f'<breakpoint program="p" vertex="v1" when="{"x" * 2000}"/>',
        '<failure at="3"/>',
        '<failure agent="c" at="-1"/>',
        '<failure agent="c" at="nan"/>',
        '<failure agent="c" at="3" kind="explode"/>',
    ],
)
def test_one_that_is_wrong_is_kept_word_for_word(wrong: str) -> None:
    mission, problems = read(wrong)
    assert len(problems) == 1
    assert mission.unknown == [wrong]
    assert (mission.breakpoints, mission.failures) == ([], [])


def test_a_failure_of_nobody_is_told() -> None:
    mission, problems = read('<failure agent="cc" at="1"/>')
    assert problems == ["“cc”, which is to fail, is not in the team"]
    assert mission.failures == [Failure("cc", 1.0)]


def test_they_travel() -> None:
    mission, _ = read(PLAIN, FULL, FAILS)
    shape = MissionShape.model_validate_json(mission_shape(mission).model_dump_json())
    assert mission_from_shape(shape) == mission


def test_differences_and_merging() -> None:
    base, _ = read(PLAIN)
    ours, _ = read(PLAIN.replace("/>", ' hits="2"/>'))
    theirs, _ = read(PLAIN, FULL, FAILS)
    assert [one.sentence for one in differences(base, ours)] == ["the breakpoint at v1 of p: hits changed"]
    assert [one.sentence for one in differences(base, theirs)] == [
        "the breakpoint at v2 of p for a b, c added",
        "the failure of c at 12.5 s added",
        "the failure of a b at 0 s added",
    ]
    merged = merge_missions(base, ours, theirs)
    assert merged.conflicts == ()
    assert merged.mission.breakpoints == [Breakpoint("p", "v1", hits=2), theirs.breakpoints[1]]
    assert merged.mission.failures == theirs.failures
