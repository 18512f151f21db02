"""Constructors and variables that a mission brings along: in the file, in the catalogue, compared and merged."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from kitrobot.mission.model import Mission
from kitrobot.mission.reader import read_mission
from kitrobot.mission.writer import write_mission
from kitrobot.primitives.constructors import Constructor, Slot, SlotKind
from kitrobot.primitives.own_xml import MOST_OWN, OWN_GROUP
from kitrobot.versions.comparison import differences
from kitrobot.versions.mission_merge import merge_missions
from kitrobot.workspace.mission_loader import read_mission_data
from kitrobot.workspace.search_path import SearchPath

HEAD = '<kitrobot version="1">'
DANCE = """<constructor name="Dance" colour="action"><label xml:lang="fr">Danse</label>
  <number name="n" min="1" max="9" default="3"/><condition name="c"/><flow name="body"/>
  <code>{n}*(Wheel.Advance(50); *[{c}]({body}); Wheel.Stop())</code></constructor>"""
TRIPS = '<variable robot="mini-robot" name="Trips" max="9"/>'
OK = '<variable robot="mini-robot" name="Ok" type="boolean" initial="true" shared="yes"><help>So far.</help></variable>'
PROGRAM = """<program name="p" robot="mini-robot"><vertex id="start" element="Start"/><vertex id="d" element="Dance">
  <set name="n">4</set></vertex><vertex id="t" element="Trips.LessThan"><set name="value">5</set></vertex>
  <vertex id="a" element="Trips.Add"><set name="value">2</set></vertex><vertex id="stop" element="Stop"/>
  <arc from="start" to="d"/><arc from="t" to="d" at="c"/><arc from="d" out="body" to="a"/>
  <arc from="a" to="d" at="return"/><arc from="d" to="stop"/></program>"""


def read(*parts: str) -> tuple[Mission, list[str]]:
    mission, problems = read_mission("\n".join((HEAD, *parts, "</kitrobot>")).encode(), "m.krt")
    assert mission is not None
    return mission, [f"{item.place.line if item.place else 0}: {item.message}" for item in problems]


def test_they_are_read_and_written_the_same() -> None:
    mission, problems = read(DANCE, TRIPS, OK)
    assert problems == []
    assert [one.name for one in mission.constructors] == ["Dance"]
    assert mission.constructors[0].group == OWN_GROUP
    assert [(one.robot, one.variable.name, one.variable.maximum) for one in mission.variables] == [
        ("mini-robot", "Trips", 9),
        ("mini-robot", "Ok", 1),
    ]
    written = write_mission(mission)
    assert read_mission(written, "m.krt") == (mission, [])
    assert written.decode().splitlines()[1:3] == [
        '  <constructor name="Dance" colour="action">',
        '    <label xml:lang="fr">Danse</label>',
    ]


def test_one_that_is_wrong_is_kept_word_for_word() -> None:
    wrong = '<constructor name="Odd" colour="loop"><code>{n}*()</code></constructor>'
    twice = '<variable robot="mini-robot" name="Trips" max="20"/>'
    mission, problems = read(DANCE, wrong, TRIPS, twice)
    assert mission.unknown == [wrong, twice]
    assert len(problems) == 2
    assert "{n} has no slot" in problems[0]
    assert "Trips" in problems[1]
    assert "already" in problems[1]
    again = read_mission(write_mission(mission), "m.krt")[0]
    assert again is not None
    assert write_mission(again) == write_mission(mission)


@pytest.mark.parametrize(
    "wrong",
    [
        '<variable name="A"/>',
        '<variable robot="" name="A"/>',
        '<variable robot="mini-robot"/>',
        '<variable robot="mini-robot" name="WAIT"/>',
        '<variable robot="mini-robot" name="A" min="5" max="2"/>',
        '<variable robot="mini-robot" name="A" initial="500"/>',
        '<constructor colour="loop"><code>Wheel.Stop()</code></constructor>',
        '<constructor name="Start" colour="loop"><code>Wheel.Stop()</code></constructor>',
        '<constructor name="A" colour="pink"><code>Wheel.Stop()</code></constructor>',
        '<constructor name="A" colour="loop"/>',
        '<constructor name="A" colour="loop"><code>Wheel.Stop(</code></constructor>',
    ],
)
def test_mistakes_have_a_place_and_lose_nothing(wrong: str) -> None:
    mission, problems = read(wrong)
    assert problems
    assert all(problem.startswith("2: ") for problem in problems)
    assert mission.unknown == [wrong]
    assert (mission.constructors, mission.variables) == ([], [])


def test_too_many_are_kept_but_not_used() -> None:
    many = [f'<variable robot="mini-robot" name="A{number}"/>' for number in range(MOST_OWN + 3)]
    mission, problems = read(*many)
    assert len(mission.variables) == MOST_OWN
    assert len(mission.unknown) == 3
    assert len(problems) == 3


def test_programs_use_them(tmp_path: Path) -> None:
    data = "\n".join((HEAD, DANCE, TRIPS, PROGRAM, "</kitrobot>")).encode()
    opened = read_mission_data(data, "m.krt", SearchPath(tmp_path))
    report = opened.check()
    assert [problem.code for problem in report.problems] == ["run-no-agent"]
    assert "Trips.LessThan(5)" in report.programs[0].lll
    assert "4*(" in report.programs[0].lll
    assert report.programs[0].instructions > 0


def test_a_name_that_the_robot_has_is_an_error(tmp_path: Path) -> None:
    taken = '<variable robot="mini-robot" name="Count"/>'
    opened = read_mission_data("\n".join((HEAD, taken, "</kitrobot>")).encode(), "m.krt", SearchPath(tmp_path))
    assert [problem.code for problem in opened.check().problems if problem.is_error] == ["own-variable"]


def test_differences_are_told() -> None:
    before, _ = read(DANCE, TRIPS)
    after, _ = read(DANCE.replace('max="9"', 'max="8"'), OK)
    assert [one.sentence for one in differences(before, after)] == [
        "the own part Dance: slots changed",
        "the variable Trips of mini-robot removed",
        "the variable Ok of mini-robot added",
    ]


def test_two_people_may_add_different_ones() -> None:
    base, _ = read(DANCE)
    ours, _ = read(DANCE, TRIPS)
    theirs, _ = read(DANCE.replace('max="9"', 'max="8"'), OK)
    merged = merge_missions(base, ours, theirs)
    assert merged.conflicts == ()
    assert [one.variable.name for one in merged.mission.variables] == ["Trips", "Ok"]
    assert merged.mission.constructors == theirs.constructors
    changed = replace(ours, constructors=[_other()])
    both = merge_missions(base, changed, replace(theirs, constructors=[]))
    assert both.conflicts == ("the own part Dance was changed in both: ours is kept",)
    assert both.mission.constructors == changed.constructors


def _other() -> Constructor:
    mission, _ = read('<constructor name="Dance" colour="loop"><code>Wheel.Stop()</code></constructor>')
    return mission.constructors[0]


def test_every_kind_of_slot_survives() -> None:
    text = """<constructor name="All" icon="star" colour="choice"><help>All of them.</help><flow name="f" loop="yes"/>
      <condition name="c"><label>Test</label></condition><value name="v" min="-3" max="9" default="2" unit="%"/>
      <number name="n" default="5"/><text name="t" default="7"/><action name="a"/>
      <code>{n}*([{c}]({f}); Motor.Turn({v}); °{a}°; Motor.Turn({t}))</code></constructor>"""
    mission, problems = read(text)
    assert problems == []
    slots = mission.constructors[0].slots
    assert list(map(str, (slot.kind for slot in slots))) == ["flow", "condition", "value", "number", "text", "action"]
    assert slots[2] == Slot("v", SlotKind.VALUE, minimum=-3, maximum=9, default="2", unit="%")
    again, _ = read_mission(write_mission(mission), "m.krt")
    assert again == mission


def test_variables_of_different_robots_may_share_a_name() -> None:
    mission, problems = read(TRIPS, TRIPS.replace("mini-robot", "carrier"))
    assert problems == []
    assert [one.robot for one in mission.variables] == ["mini-robot", "carrier"]
