"""What a file holds that KitRobot does not know is there again when it is written, or a warning says that it is not."""

from __future__ import annotations

import random
import re
from collections.abc import Callable
from typing import Any
from xml.etree import ElementTree

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kitrobot.diagnostics.model import Diagnostic
from kitrobot.mission.model import Mission
from kitrobot.mission.reader import read_mission
from kitrobot.mission.writer import write_mission
from kitrobot.primitives.kit_xml import read_kit, write_kit
from kitrobot.wire.mission import MissionShape, mission_from_shape, mission_shape
from kitrobot.world.xml_reader import read_world
from kitrobot.world.xml_writer import write_world
from tests.versions.test_renames import TEXT as MISSION

WORLD = """<world version="1" name="yard" width="3000" height="3000">
  <label>A yard</label>
  <road name="way" width="200"><point x="500" y="500"/><point x="2500" y="500"/></road>
  <floor colour="red"><point x="5" y="5"/><point x="9" y="5"/><point x="9" y="9"/></floor>
  <start name="west" x="1000" y="2000"/>
</world>
"""
KIT = """<board name="mine" version="1" pins="0..9">
  <label>Mine</label>
  <tried how="documents"/>
  <supply>A board</supply>
  <step>Put it together.</step>
  <actuator device="wheels" driver="two-pins" left="1" right="2"><help>The motors</help></actuator>
  <missing device="arm"/>
</board>
"""
OWN = """  <breakpoint program="search" vertex="v1"><agent name="ada"/></breakpoint>
  <property name="bump" eventually="any ada (Collision.IsPressed())"/>
  <failure agent="bob" at="3"/>
"""

Read = Callable[[bytes, str], tuple[Any, list[Diagnostic]]]
Write = Callable[[Any], bytes]


def on_the_wire(mission: Mission) -> bytes:
    """As the studio saves it: through the page and back."""
    return write_mission(mission_from_shape(MissionShape.model_validate_json(mission_shape(mission).model_dump_json())))


KINDS: dict[str, tuple[str, Read, Write]] = {
    "mission": (MISSION.replace("  <world", OWN + "  <world", 1), read_mission, write_mission),
    "mission of the studio": (MISSION, read_mission, on_the_wire),
    "world": (WORLD, read_world, write_world),
    "kit": (KIT, read_kit, lambda kit: write_kit(kit).encode()),
}
each_kind = pytest.mark.parametrize("kind", KINDS)
TAG = re.compile(r"<[^!?][^>]*>")


def with_foreign(text: str, dice: random.Random, count: int) -> tuple[str, list[str]]:
    """The text with foreign things in legal places, and a word for each that stands nowhere else."""
    tags, added = list(TAG.finditer(text)), []
    for number in range(count):
        word = f"w{number}x{dice.randrange(10**6)}"
        tag = dice.choice(tags)
        if dice.random() < 0.3 and not tag.group().startswith("</"):
            at = tag.end() - (2 if tag.group().endswith("/>") else 1)
            added.append((at, word, dice.choice([f' {word}="1"', f' f{number}:{word}="1" xmlns:f{number}="urn:f"'])))
            continue
        at = dice.choice([0, len(text), *(one.end() for one in tags[:-1])])
        choices = [f"<!-- {word} - -->", f"<?{word} a?>"]
        if 0 < at < len(text):
            inside = f'<f:{word} xmlns:f="urn:f"><!-- -->&amp;<f:g h="1"/></f:{word}>'
            choices += [f"<{word}/>", f"<{word} xmlns='urn:d'><b/></{word}>", inside, f"<s:{word} s:a='1'/>"]
        added.append((at, word, dice.choice(choices)))
    for at, _, xml in sorted(added, key=lambda one: -one[0]):
        text = text[:at] + xml + text[at:]
    root = next(one for one in TAG.finditer(text))
    start = root.end() - 1
    about = (
        ' xmlns:s="urn:school" xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xsi:schemaLocation="a b" s:y="2"'
    )
    return text[:start] + about + text[start:], [word for _, word, _ in added]


@each_kind
@given(seed=st.integers(0, 10**9), count=st.integers(0, 6))
def test_what_is_foreign_is_written_again_or_told(kind, seed, count):
    text, read, write = KINDS[kind]
    text, words = with_foreign(text, random.Random(seed), count)
    ElementTree.fromstring(text)
    found, problems = read(text.encode(), "f.xml")
    assert found is not None, problems
    written = write(found).decode()
    root = ElementTree.fromstring(written)
    assert root.get("{http://www.w3.org/2001/XMLSchema-instance}schemaLocation") == "a b"
    assert root.get("{urn:school}y") == "2"
    told = " ".join(str(item.message) for item in problems if "left out" in item.message)
    for word in words:
        assert written.count(word) >= 1 or word in told, word
        assert written.count(word) <= 2  # a start and an end tag
    again, _ = read(written.encode(), "f.xml")
    assert write(again).decode() == written


@each_kind
def test_a_namespace_of_the_first_element_is_that_of_what_is_kept(kind):
    text, read, write = KINDS[kind]
    head, end, rest = text.partition(">\n")
    found, _ = read(f'{head} xmlns:school="urn:s"{end}<school:class school:name="5b"/>{rest}'.encode(), "f.xml")
    root = ElementTree.fromstring(write(found))
    assert [one.attrib for one in root.iter("{urn:s}class")] == [{"{urn:s}name": "5b"}]


@each_kind
def test_comments_and_instructions_before_the_first_element_stay_there(kind):
    text, read, write = KINDS[kind]
    before = '<?xml-stylesheet href="a.xsl"?>\n<!-- Group 4:\n keep it slow. -->\n'
    found, problems = read(f'<?xml version="1.0"?>\n{before}{text}'.encode(), "f.xml")
    assert problems == []
    if kind != "mission":
        assert write(found).decode().startswith(before)


def test_a_comment_in_a_program_goes_with_the_part_behind_it():
    text = MISSION.replace('<vertex id="v2" element="Hop">', '<!-- twice -->\n    <vertex id="v2" element="Hop">')
    mission, problems = read_mission(text.encode(), "m.krt")
    assert mission is not None
    assert problems == []
    assert (
        '<vertex id="v2" element="Hop"><set name="times">3</set><!-- twice --></vertex>'
        in write_mission(mission).decode()
    )


def test_an_element_with_a_mistake_keeps_its_comment_once():
    raw = '<failure agent="bob" at="soon"><!-- when? --></failure>'
    mission, _ = read_mission(MISSION.replace("  <world", f"{raw}\n  <world", 1).encode(), "m.krt")
    assert mission is not None
    again, _ = read_mission(write_mission(mission), "m.krt")
    assert again == mission
    assert mission.unknown == [raw]


@pytest.mark.parametrize(
    "raw", ["<a:b/>", "<a", "a & b", "<!-- ", "</kitrobot>", "<a:b:c/>", "<!DOCTYPE a>", "\x00", "--", "<?a:b?>", "a-"]
)
def test_what_is_no_xml_does_not_break_the_file(raw):
    mission, _ = read_mission(MISSION.encode(), "m.krt")
    assert mission is not None
    mission.unknown, mission.prolog = [raw], [raw, '<?xml version="1.0" encoding="utf-16"?>']
    mission.programs[0].vertices[0].unknown = raw
    mission.attributes = {"q:a": "1", "version": "7", 'x:y="1" z': "2", "a:b:c": "1", "xmlns:": "", "xsi:type": "t"}
    written = write_mission(mission)
    ElementTree.fromstring(written)
    read, problems = read_mission(written, "m.krt")
    assert read is not None
    assert [item.message for item in problems if item.is_error] == []
    assert read.attributes["q:a"] == "1"
