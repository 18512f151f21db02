"""The world that a mission brings along: read, written, wrong, compared, merged, on the wire, run."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
import xmlschema
from hypothesis import given

import kitrobot.primitives
from kitrobot.diagnostics.model import Diagnostic
from kitrobot.mission.model import Mission
from kitrobot.mission.reader import read_mission
from kitrobot.mission.writer import write_mission
from kitrobot.versions.comparison import differences
from kitrobot.versions.mission_merge import merge_missions
from kitrobot.wire.mission import MissionShape, mission_from_shape, mission_shape
from kitrobot.workspace.mission_loader import open_mission, with_mission
from kitrobot.workspace.search_path import SearchPath
from kitrobot.world.lookup import SHIPPED
from kitrobot.world.model import Wall, World
from kitrobot.world.xml_reader import check_plan, read_world
from kitrobot.world.xml_writer import write_world
from tests.strategies.worlds import worlds

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
RING = (SHIPPED / "ring.world.xml").read_text()
SCHEMA = Path(kitrobot.primitives.__file__).parent / "schemas" / "mission.xsd"


def read(world: str) -> tuple[Mission, list[Diagnostic]]:
    mission, problems = read_mission(f'<kitrobot version="1">\n{world}\n</kitrobot>'.encode(), "m.krt")
    assert mission is not None
    return mission, problems


def own(text: str = RING) -> World:
    mission, _ = read(text)
    assert mission.own_world is not None
    return mission.own_world


def test_a_world_stands_inside_a_mission_as_in_its_file() -> None:
    mission, problems = read(RING)
    assert problems == []
    assert mission.own_world == read_world(RING.encode(), "ring")[0]
    written = write_mission(mission)
    assert read_mission(written, "m.krt") == (mission, [])
    assert '    <road name="ring" width="125" closed="yes">' in written.decode().splitlines()
    xmlschema.XMLSchema(SCHEMA).validate(written.decode())


@given(worlds)
def test_any_world_comes_back_from_the_file_and_from_the_wire(world: World) -> None:
    mission = Mission(own_world=world)
    written = write_mission(mission)
    found, problems = read_mission(written, "m.krt")
    assert found is not None
    assert found.unknown == []
    assert write_mission(found) == written
    shape = MissionShape.model_validate_json(mission_shape(found).model_dump_json())
    assert write_mission(mission_from_shape(shape)) == written
    told = [(item.code, item.message, item.thing) for item in check_plan(world)[1]]
    assert [(item.code, item.message, item.thing) for item in problems] == told


@given(worlds)
def test_no_plan_makes_a_world_that_does_not_hold_together(world: World) -> None:
    sound, problems = check_plan(world)
    if sound is None:
        assert problems
        return
    for dock in sound.docks:
        sound.dock_pose(dock)
    for start in sound.starts:
        sound.start_pose(start)
    assert check_plan(sound)[1] == ()


@pytest.mark.parametrize(
    "wrong",
    [
        '<world version="1" name="w" width="100"/>',
        '<world version="1" name="w" width="nan" height="1"/>',
        '<world version="1" name="w" width="1e300" height="10"/>',
        '<world version="9" name="w" width="100" height="100"/>',
        '<world version="1" name="w" width="100" height="100"><wall x1="a" y1="0" x2="1" y2="1"/></world>',
        '<world version="1" name="w" width="100" height="100"><start name="a" x="1" y="1" dock="d"/></world>',
        '<world version="1" name="w" width="100" height="100"><start name="a"/></world>',
        '<world version="1" name="w" width="100" height="100"><line colour="pink" width="3"/></world>',
        '<world href="ring.world.xml"><wall x1="0" y1="0" x2="1" y2="1"/></world>',
        '<world href="ring.world.xml" name="w"/>',
    ],
)
def test_one_that_cannot_be_understood_is_kept_word_for_word(wrong: str) -> None:
    mission, problems = read(wrong)
    assert (mission.own_world, mission.world_href, mission.unknown) == (None, "", [wrong])
    assert [(item.is_error, item.place is not None and item.place.line) for item in problems] == [(True, 2)]
    again, _ = read_mission(write_mission(mission), "m.krt")
    assert again == mission


def test_what_does_not_fit_is_told_with_its_line_and_its_thing_and_stays_as_it_is() -> None:
    text = RING.replace('at="40"', 'at="4000"').replace('stock="12"', 'stock="13"')
    mission, problems = read(text)
    assert [(item.code, item.thing) for item in problems] == [
        ("world-storehouse", "storehouse:0"),
        ("world-dock", "dock:0"),
    ]
    lines = f"\n{text}".splitlines()
    assert problems[1].place is not None
    assert '<dock name="A"' in lines[problems[1].place.line - 1]
    assert mission.own_world is not None
    assert mission.own_world.docks[0].at_mm == 4000
    assert 'at="4000"' in write_mission(mission).decode()


def test_a_problem_behind_the_world_is_not_of_it() -> None:
    _, problems = read(f'{RING}\n<team><agent name="a" program="none"/></team>')
    assert [(item.code, item.thing) for item in problems] == [("mission-no-program", "")]


def test_the_first_world_counts() -> None:
    mission, problems = read(f'<world href="ring.world.xml"/>{RING}')
    assert (mission.world_href, mission.own_world) == ("ring.world.xml", None)
    assert [item.code for item in problems] == ["mission-world"]


def test_what_nobody_knows_in_it_is_kept() -> None:
    text = RING.replace("</world>", '  <weather kind="rain">\n wet\n</weather>\n</world>')
    mission, problems = read(text)
    assert [item.code for item in problems] == ["xml-unknown-element"]
    assert '<weather kind="rain">\n wet\n</weather>' in write_mission(mission).decode()


def test_a_mission_runs_the_same_in_a_copy_of_its_world() -> None:
    opened = open_mission(EXAMPLES / "transport" / "transport.krt")
    alone = replace(opened.mission, world_href="", own_world=opened.world)
    copied = with_mission(alone, "alone.krt", SearchPath(EXAMPLES / "transport"))
    assert copied.check().problems == opened.check().problems
    first, second = opened.run(seed=3, seconds=60), copied.run(seed=3, seconds=60)
    assert (first.ticks, first.delivered, first.outcome) == (second.ticks, second.delivered, second.outcome)


def test_what_is_wrong_with_it_keeps_a_mission_from_running() -> None:
    opened = open_mission(EXAMPLES / "transport" / "transport.krt")
    assert opened.world is not None
    bad = replace(opened.world, walls=(Wall(0, 0, 9000, 0),))
    mission = replace(opened.mission, world_href="", own_world=bad)
    report = with_mission(mission, "bad.krt", SearchPath(EXAMPLES / "transport")).check()
    assert not report.ok
    assert [(item.code, item.thing, item.place) for item in report.problems] == [("world-outside", "wall:0", None)]


def test_differences_in_words() -> None:
    base = Mission(own_world=own())
    changed = own(
        RING.replace('at="40"', 'at="60" side="right"')
        .replace('width="1200"', 'width="1300"')
        .replace('<dock name="B"', '<wall x1="0" y1="0" x2="1" y2="1"/><dock name="C"')
        .replace("</world>", '<zone kind="warm" x="9" y="9" radius="9" value="30"/></world>')
    )
    assert [one.sentence for one in differences(base, Mission(own_world=changed))] == [
        "the world: its width changed",
        "the world: wall 1 added",
        "the world: dock B removed",
        "the world: dock A: at, side changed",
        "the world: dock C added",
        "the world: zone 1 added",
    ]
    assert [one.sentence for one in differences(Mission(world_href="ring.world.xml"), base)] == [
        "the world: ring.world.xml → its own, ring"
    ]
    assert differences(base, base) == []


@given(worlds, worlds)
def test_two_worlds_that_differ_never_compare_as_equal(one: World, other: World) -> None:
    found = differences(Mission(own_world=one), Mission(own_world=other))
    assert bool(found) == (one != other)


def test_edits_of_two_people_come_together() -> None:
    base = Mission(own_world=own())
    ours = Mission(own_world=own(RING.replace('at="40"', 'at="60"')))
    theirs = Mission(
        own_world=own(
            RING.replace('stock="12"', 'stock="5"').replace(
                "<storehouse", '<wall x1="0" y1="0" x2="9" y2="0"/><storehouse', 1
            )
        )
    )
    merged = merge_missions(base, ours, theirs)
    assert merged.conflicts == ()
    world = merged.mission.own_world
    assert world is not None
    assert (world.docks[0].at_mm, world.storehouses[0].stock, len(world.walls)) == (60, 5, 1)
    clash = merge_missions(base, ours, Mission(own_world=own(RING.replace('at="40"', 'at="70"'))))
    assert clash.conflicts == ("the dock A was changed in both: ours is kept",)
    away = merge_missions(base, base, Mission(world_href="ring.world.xml"))
    assert (away.mission.world_href, away.mission.own_world) == ("ring.world.xml", None)
    torn = merge_missions(base, ours, Mission(world_href="merge.world.xml"))
    assert torn.mission == ours
    assert torn.conflicts == ("the world of the mission was changed in both: ours is kept",)


def test_zones_of_two_people_come_together_and_one_that_says_no_shape_is_kept_word_for_word() -> None:
    zone = '<zone kind="{}" x="9" y="9" {} value="30" falloff="0"/></world>'
    one, other = (zone.format(kind, 'radius="9"') for kind in ("warm", "loud"))
    base, ours, theirs = (
        Mission(own_world=own(text)) for text in (RING, RING.replace("</world>", one), RING.replace("</world>", other))
    )
    merged = merge_missions(base, ours, theirs)
    assert merged.conflicts == ()
    assert merged.mission.own_world is not None
    assert [found.kind for found in merged.mission.own_world.zones] == ["warm", "loud"]
    wrong = RING.replace("</world>", zone.format("warm", 'radius="9" width="9"')).rstrip()
    mission, problems = read(wrong)
    assert (mission.own_world, mission.unknown) == (None, [wrong])
    assert [item.code for item in problems] == ["world-zone"]


def test_a_plan_is_written_as_its_file() -> None:
    assert write_world(own()) == RING.encode()
