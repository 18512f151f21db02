"""World files: the shipped ones, the round trip, and every mistake with its line and column."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import pytest
import xmlschema
from hypothesis import given
from hypothesis import strategies as st

from kitrobot.diagnostics.model import Severity
from kitrobot.world.lookup import SHIPPED, find_world
from kitrobot.world.model import World
from kitrobot.world.xml_reader import read_world
from kitrobot.world.xml_writer import write_world
from kitrobot.xml.element import Element

GOOD = """\
<world version="1" name="test" width="2000" height="1000">
  <wall x1="0" y1="0" x2="2000" y2="0"/>
  <line colour="green" width="20">
    <point x="100" y="100"/>
    <point x="900" y="100"/>
  </line>
  <road name="lane" width="120">
    <point x="200" y="500"/>
    <point x="1200" y="500"/>
    <section sign="4" from="0" to="400"/>
    <section sign="7" from="400"/>
  </road>
  <storehouse name="A" x="100" y="700" width="200" height="200" capacity="9" stock="3"/>
  <dock name="in" road="lane" at="100" reach="40" storehouse="A" kind="load" side="right"/>
  <start name="one" road="lane" at="700"/>
  <start name="two" x="1500" y="300" heading="90"/>
  <start name="three" dock="in"/>
  <start name="four" storehouse="A"/>
</world>
"""


def world(text: str = GOOD) -> World:
    found, problems = read_world(text.encode(), "test.world.xml")
    assert problems == []
    assert found is not None
    return found


def problems_of(text: str) -> list[tuple[str, int, str, str]]:
    """(code, line, the text under the carets, message) of everything found wrong."""
    _, problems = read_world(text.encode(), "test.world.xml")
    lines = text.split("\n")
    found: list[tuple[str, int, str, str]] = []
    for problem in problems:
        place = problem.place
        assert place is not None
        marked = lines[place.line - 1][place.column - 1 : place.end_column - 1]
        found.append((problem.code, place.line, marked, problem.message))
    return found


def test_a_world_that_was_written_is_written_again_to_the_byte() -> None:
    assert write_world(world()).decode() == GOOD


@pytest.mark.parametrize("path", sorted(SHIPPED.glob("*.world.xml")), ids=lambda path: path.name)
def test_every_shipped_world_is_right_and_in_the_true_layout(path: Path) -> None:
    data = path.read_bytes()
    assert write_world(world(data.decode())) == data
    assert world(data.decode()).help


def test_the_ring_has_six_sections_two_docks_and_room_for_twelve_boxes_each() -> None:
    ring = world((SHIPPED / "ring.world.xml").read_text())
    road = ring.roads[0]
    assert road.closed
    assert [section.sign for section in road.sections] == [0, 1, 2, 3, 4, 5]
    for dock, sign in zip(ring.docks, (0, 3), strict=True):
        section = road.section_at(dock.at_mm)
        assert section is not None
        assert section.sign == sign
        # Near the start of the section: who queues behind stays in the section before.
        assert dock.at_mm - section.from_mm < 50
    assert [(house.name, house.capacity, house.stock) for house in ring.storehouses] == [("A", 12, 12), ("B", 12, 0)]
    names = [start.name for start in ring.starts]
    assert names == ["carrier-1", "carrier-2", "carrier-3", "loader", "unloader", "store-manager-A", "store-manager-B"]
    left, right = ring.dock_pose(ring.docks[0]), ring.dock_pose(ring.docks[1])
    assert left.x_mm < 600 < right.x_mm


def test_a_start_at_a_dock_stands_beside_the_road_and_looks_at_it() -> None:
    found = world()
    start = found.start("three")
    assert start is not None
    pose = found.start_pose(start)
    assert (pose.x_mm, pose.y_mm) == pytest.approx((300, 400))
    assert pose.heading_rad == pytest.approx(3.14159 / 2, abs=1e-4)


def test_the_sections_of_a_road_are_found_by_mm() -> None:
    road = world().roads[0]
    signs = [section.sign for at in (0, 399.9, 400, 1000) if (section := road.section_at(at))]
    assert signs == [4, 4, 7, 7]


@pytest.mark.parametrize(
    ("old", "new", "code", "line", "marked", "words"),
    [
        ('sign="7" from="400"', 'sign="7" from="420"', "world-sections", 11, "420", "a gap of 20 mm"),
        ('sign="7" from="400"', 'sign="7" from="380"', "world-sections", 11, "380", "an overlap of 20 mm"),
        ('sign="7" from="400"', 'sign="7" from="400" to="900"', "world-sections", 11, "900", "at 1000 mm, found 900"),
        ('sign="7" from="400"', 'sign="4" from="400"', "xml-duplicate", 11, "4", "stands on this road already"),
        ('from="0" to="400"', 'from="0"', "xml-missing", 10, "<section", "every <section> but the last"),
        ('from="0" to="400"', 'from="0" to="0"', "world-sections", 10, "0", "before it begins"),
        ('at="100" reach', 'at="1001" reach', "world-dock", 14, "1001", "from 0 to 1000 mm, found 1001"),
        ('road="lane" at="100"', 'road="lame" at="100"', "world-unknown-name", 14, "lame", "<road> of this world"),
        ('storehouse="A" kind', 'storehouse="C" kind', "world-unknown-name", 14, "C", "<storehouse>"),
        ('kind="load"', 'kind="lode"', "xml-bad-value", 14, "lode", "load or unload"),
        ('name="one" road="lane"', 'name="one" road="lake"', "world-unknown-name", 15, "lake", "“lake”"),
        ('at="700"', 'at="1700"', "world-start", 15, "1700", "found 1700"),
        ('x="1500" y="300"', 'x="1500" y="5"', "world-start", 16, "<start", "two starts in a wall"),
        ('x="1500" y="300"', 'x="2500" y="300"', "world-outside", 16, "<start", "outside the world"),
        ('<start name="two" x="1500" y="300"', '<start name="two"', "world-start", 16, "<start", "none of them"),
        (
            '<start name="three" dock="in"',
            '<start name="three" dock="in" road="lane"',
            "world-start",
            17,
            "<start",
            "road and dock",
        ),
        ('name="four" storehouse', 'name="three" storehouse', "xml-duplicate", 18, "three", "is there already"),
        ('stock="3"', 'stock="10"', "world-storehouse", 13, "10", "at most 9 boxes"),
        ('<point x="1200" y="500"/>', "", "world-line", 7, "<road", "two points"),
        ('<point x="1200" y="500"/>', '<point x="1200" y="2500"/>', "world-outside", 7, "<road", "outside the world"),
        ('colour="green"', 'colour="greem"', "xml-bad-value", 3, "greem", "red, green or blue"),
        ('width="2000"', 'width="wide"', "xml-bad-value", 1, "wide", "a number"),
    ],
)
def test_a_mistake_is_said_at_its_place(old: str, new: str, code: str, line: int, marked: str, words: str) -> None:
    assert old in GOOD
    found = problems_of(GOOD.replace(old, new, 1))
    assert (code, line, marked) in [problem[:3] for problem in found], found
    assert any(words in problem[3] for problem in found), found


def test_a_section_may_miss_by_a_millimetre_and_not_by_more() -> None:
    assert problems_of(GOOD.replace('from="400"', 'from="401"')) == []
    assert problems_of(GOOD.replace('from="400"', 'from="401.1"')) != []


def test_what_names_a_part_with_a_mistake_is_not_blamed_too() -> None:
    found = problems_of(GOOD.replace('<point x="1200" y="500"/>', ""))
    assert [problem[0] for problem in found] == ["world-line"]


def test_the_good_parts_of_a_bad_world_are_kept() -> None:
    found, problems = read_world(GOOD.replace('kind="load"', 'kind="lode"').encode(), "w")
    assert len(problems) == 1
    assert problems[0].severity is Severity.ERROR
    assert found is not None
    assert found.docks == ()
    assert len(found.roads) == 1
    assert [start.name for start in found.starts] == ["one", "two", "four"]


@pytest.mark.parametrize(
    "data",
    [
        b"",
        b"<world",
        b"<robot/>",
        GOOD.encode()[:300],
        b'<?xml version="1.0"?><!DOCTYPE world [<!ENTITY a "b">]><world/>',
        b"<world>" * 10_000,
        GOOD.encode("utf-16-le"),
        b"\xff\xfe\xfd",
        GOOD.replace('version="1"', 'version="2"').encode(),
    ],
    ids=["empty", "cut", "another", "half", "dtd", "deep", "encoding", "bytes", "newer"],
)
def test_a_file_that_cannot_be_used_gives_one_error(data: bytes) -> None:
    found, problems = read_world(data, "bad.world.xml")
    assert found is None
    assert len(problems) == 1
    assert problems[0].place is not None
    assert problems[0].place.file == "bad.world.xml"


@given(st.data())
def test_a_damaged_world_never_escapes_as_an_exception(data: st.DataObject) -> None:
    text = (SHIPPED / "ring.world.xml").read_bytes()
    at = data.draw(st.integers(0, len(text) - 1))
    length = data.draw(st.integers(0, 30))
    found, problems = read_world(text[:at] + data.draw(st.binary(max_size=4)) + text[at + length :], "w")
    assert found is not None or problems


def test_a_world_is_found_beside_the_mission_before_the_shipped_one(tmp_path: Path) -> None:
    assert find_world("ring.world.xml", [tmp_path]) == SHIPPED / "ring.world.xml"
    (tmp_path / "ring.world.xml").write_text(GOOD)
    assert find_world("ring.world.xml", [tmp_path]) == tmp_path / "ring.world.xml"
    assert find_world("", [tmp_path]) == SHIPPED / "empty.world.xml"
    assert find_world("none.world.xml", [tmp_path]) is None


@pytest.mark.parametrize("href", ["../ring.world.xml", "/etc/passwd", "a/../../b.world.xml", "a\\b", "a\0b"])
def test_a_name_that_leads_out_of_its_folder_is_never_followed(tmp_path: Path, href: str) -> None:
    inner = tmp_path / "inner"
    inner.mkdir()
    (tmp_path / "ring.world.xml").write_text(GOOD)
    assert find_world(href, [inner]) is None


FLOORS = """\
<world version="1" name="test" width="2000" height="1000">
  <floor colour="red" x="100" y="200.5" width="300.1" height="50"/>
  <floor colour="blue">
    <point x="600" y="100" radius="200"/>
    <point x="1000" y="100" radius="200"/>
    <point x="1000" y="500" radius="200"/>
    <point x="600" y="500" radius="200"/>
  </floor>
  <floor colour="green">
    <point x="1200" y="100"/>
    <point x="1600" y="100"/>
    <point x="1400" y="500"/>
  </floor>
</world>
"""


def test_coloured_floors_are_rectangles_and_what_points_enclose_and_are_written_again_to_the_byte() -> None:
    found = world(FLOORS)
    assert [floor.colour for floor in found.floors] == ["red", "blue", "green"]
    assert found.floors[0].rectangle == pytest.approx((100, 200.5, 300.1, 50))
    # A square with corners as round as half its side is a circle.
    assert found.floors[1].rectangle is None
    assert found.floors[1].line.length_mm == pytest.approx(400 * math.pi)
    assert write_world(found).decode() == FLOORS


@pytest.mark.parametrize(
    ("old", "new", "code", "line", "words"),
    [
        ('width="300.1"', "", "xml-missing", 2, "width"),
        ('width="300.1"', 'width="0"', "xml-bad-value", 2, "0.1"),
        ('width="300.1"', 'width="3000"', "world-outside", 2, "outside the world"),
        (' x="100" y="200.5" width="300.1" height="50"', "", "world-line", 2, "a closed one three"),
        ('colour="red"', 'colour="yellow"', "xml-bad-value", 2, "red, green or blue"),
        ('<floor colour="blue">', '<floor colour="blue" x="4" y="4" width="4" height="4">', "world-line", 3, "both"),
        ('<point x="600" y="100" radius="200"/>', '<point x="600" y="100" radius="300"/>', "world-line", 3, "no room"),
        ('<point x="1400" y="500"/>', "", "world-line", 9, "a closed one three"),
        ('<point x="1400" y="500"/>', '<point x="1400" y="5000"/>', "world-outside", 9, "outside the world"),
    ],
)
def test_a_mistake_in_a_floor_is_said_at_its_place(old: str, new: str, code: str, line: int, words: str) -> None:
    assert old in FLOORS
    found = problems_of(FLOORS.replace(old, new, 1))
    assert [problem[:2] for problem in found] == [(code, line)]
    assert words in found[0][3]


def test_schema_knows_floors() -> None:
    schema = xmlschema.XMLSchema(str(SHIPPED.parents[1] / "primitives" / "schemas" / "world.xsd"))
    assert schema.is_valid(FLOORS)
    assert not schema.is_valid(FLOORS.replace('colour="red"', 'colour="yellow"'))


@pytest.mark.parametrize("road", ["lane", "nowhere"])
def test_what_is_declared_is_gathered_once_however_many_starts_name_it(
    road: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    gathered = 0
    found = Element.found

    def counted(self: Element, kind: type[Any]) -> list[Any]:
        nonlocal gathered
        gathered += 1
        return found(self, kind)

    monkeypatch.setattr(Element, "found", counted)
    counts = []
    for many in (10, 40):
        gathered = 0
        lane = '<road name="lane" width="125"><point x="100" y="500"/><point x="9000" y="500"/></road>'
        starts = "".join(f'<start name="s{n}" road="{road}" at="{n}"/>' for n in range(many))
        text = f'<world version="1" name="m" width="10000" height="1000">{lane}{starts}</world>'
        _, problems = read_world(text.encode(), "m.world.xml")
        assert len(problems) == (0 if road == "lane" else many)
        counts.append(gathered)
    assert counts[0] == counts[1]


@pytest.mark.parametrize(
    ("thing", "words"),
    [
        ('<box x="5000" y="10" width="50" height="50"/>', "outside the world"),
        ('<box x="50" y="10" width="0" height="50"/>', "width"),
        ('<box x="50" y="10" width="50" height="50" mass="-3"/>', "mass"),
        ('<box x="nan" y="10" width="50" height="50"/>', "x"),
        ('<ball x="50" y="10" radius="1e99"/>', "radius"),
        ('<ball x="50" y="10" radius="20" friction="900"/>', "friction"),
        ('<ball x="50" y="10"/>', "radius"),
    ],
)
def test_a_box_or_ball_that_makes_no_sense_is_left_out_and_said_with_its_place(thing: str, words: str) -> None:
    text = (
        f'<world version="1" name="w" width="900" height="900">\n  {thing}\n  <ball x="1" y="2" radius="9"/>\n</world>'
    )
    world, problems = read_world(text.encode(), "w.world.xml")
    assert world is not None
    assert (world.boxes, [ball.radius_mm for ball in world.balls]) == ((), [9.0])
    [problem] = problems
    assert problem.place is not None
    assert problem.place.line == 2
    assert words in problem.message
    assert problem.thing.split(":")[0] in thing
