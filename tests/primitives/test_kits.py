"""Files of kits, `NAME.board.xml`: what they say, what is wrong with them, and that writing gives what was read."""

from __future__ import annotations

import random
from dataclasses import replace
from pathlib import Path

import pytest
import xmlschema

from kitrobot.primitives.catalogue import SHIPPED, load_catalogue
from kitrobot.primitives.kit import Kit, KitEvidence, lacks, on_kit
from kitrobot.primitives.kit_xml import LONGEST_LABEL, LONGEST_TEXT, read_kit, write_kit
from kitrobot.primitives.robot import Category
from kitrobot.text.phrases import one_of
from kitrobot.translation.languages import LANGUAGES, TEXT_LANGUAGES
from tools import schemas

GOOD = """<board name="mine" version="1" family="machine" micropython="1.20" pins="0..4 7 LED 9">
  <label>Mine</label>
  <label xml:lang="fr">Le mien</label>
  <help>What I built.</help>
  <tried how="hand" by="class 7b"/>
  <source href="https://example.org/pins.pdf">the pins</source>
  <supply>two motors</supply>
  <supply xml:lang="fr">deux moteurs</supply>
  <supply>glue</supply>
  <step>Glue the motors &amp; wait.</step>
  <actuator device="drive turn" left-forward="2" rate="200"/>
  <actuator device="drive" when="guide=road" driver="road" left-forward="2"/>
  <actuator device="lamp" part="Lamp" driver="led" pin="LED"><help>The green one.</help></actuator>
  <sensor device="colour" driver="tcs34725" sda="0" scl="1"/>
  <missing kind="actuator" device="door"><help>It has no servo.</help></missing>
</board>
"""


def read(text: str) -> tuple[Kit | None, list[str]]:
    kit, found = read_kit(text.encode(), "mine.board.xml")
    return kit, [one.message for one in found]


def good() -> Kit:
    kit, found = read(GOOD)
    assert (kit is not None, found) == (True, [])
    assert kit is not None
    return kit


def test_a_kit_says_how_parts_are_wired_and_what_is_missing() -> None:
    kit = good()
    assert (kit.name, kit.family, kit.micropython) == ("mine", "machine", "1.20")
    assert kit.pins == ("0", "1", "2", "3", "4", "7", "LED", "9")
    assert (kit.tried, kit.tried_by) == (KitEvidence.HAND, "class 7b")
    assert kit.supplies == ({"": "two motors", "fr": "deux moteurs"}, {"": "glue"})
    robots = load_catalogue().robots
    mini = on_kit(robots["mini-robot"], kit)
    told = {(part.category, part.name): (part.board.driver, dict(part.board.settings)) for part in mini.actuators}
    assert told[Category.ACTUATOR, "Wheel"] == ("drive", {"left-forward": "2", "rate": "200"})
    assert told[Category.ACTUATOR, "Motor"] == ("turn", {"left-forward": "2", "rate": "200"})
    assert mini.fingerprint == robots["mini-robot"].fingerprint
    assert {part.name for part in mini.actuators if lacks(kit, part)} == {"Door", "Light", "Pen", "Switch"}
    carrier = on_kit(robots["carrier"], kit)
    assert [part.board.driver for part in carrier.actuators] == ["road", "led"]


@pytest.mark.parametrize("path", sorted(SHIPPED.glob("*.board.xml")), ids=lambda path: path.name)
def test_a_shipped_kit_is_sound_names_its_sources_and_is_said_in_each_language(path: Path) -> None:
    kit, found = read_kit(path.read_bytes(), str(path))
    assert found == []
    assert kit is not None
    assert kit.sources
    told = [kit.label, kit.help, *kit.supplies, *kit.steps, *(part.help for part in kit.parts if part.help)]
    assert [texts for texts in told if texts.keys() != set(TEXT_LANGUAGES) or not all(texts.values())] == []
    assert [part.devices for part in kit.parts if part.is_missing and not part.help] == []
    untold = [
        texts for texts in (kit.help, *(part.help for part in kit.parts if part.help)) if len({*texts.values()}) < 3
    ]
    assert untold == [], "the same words in two languages"


def test_what_is_written_is_read_again() -> None:
    kits = [good()]
    for path in SHIPPED.glob("*.board.xml"):
        kit, _ = read_kit(path.read_bytes(), path.name)
        assert kit is not None
        kits.append(kit)
    for kit in kits:
        text = write_kit(kit)
        again, found = read_kit(text.encode(), "again.board.xml")
        assert (again, found) == (kit, [])
        assert write_kit(kit) == text


def test_pins_are_written_as_ranges_whatever_they_are() -> None:
    rng = random.Random("pins")
    for _ in range(50):
        pins = tuple(dict.fromkeys(rng.choice(["LED", "A0", *map(str, range(12))]) for _ in range(rng.randrange(12))))
        kit = replace(good(), pins=pins)
        assert read_kit(write_kit(kit).encode(), "x.board.xml")[0] == kit


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (('pins="0..4', 'pins="4..0'), "numbers, ranges and names of pins"),
        (('pins="0..4', 'pins="0..999'), "numbers, ranges and names of pins"),
        (('family="machine"', 'family="toaster"'), "machine"),
        (('micropython="1.20"', 'micropython="new"'), "a version such as 1.20"),
        (('by="class 7b"', ""), 'expected by="…"'),
        (('device="drive turn"', ""), 'expected device="…"'),
        (('device="colour"', 'device="range"'), ""),
        (('when="guide=road"', 'when="road"'), "a setting and its value"),
        (('when="guide=road" ', ""), "is there already"),
        (('rate="200"', 'rate="2 0"'), "without spaces"),
        (('version="1"', 'version="2"'), "version 1 or older"),
        (('xml:lang="fr">deux', 'xml:lang="fr">x</supply><supply xml:lang="fr">deux'), "in this language already"),
        (("</board>", ""), "board"),
    ],
)
def test_a_mistake_is_told_and_the_kit_is_left_out(change: tuple[str, str], says: str) -> None:
    assert change[0] in GOOD
    kit, found = read(GOOD.replace(*change))
    if not says:
        assert (kit is not None, found) == (True, [])
        return
    assert kit is None
    assert any(says in message for message in found), found


@pytest.mark.parametrize(
    ("name", "before", "longest"),
    [
        ("label", "<label>Mine", LONGEST_LABEL),
        ("help", "<help>What I built.", LONGEST_TEXT),
        ("help", "<help>The green one.", LONGEST_TEXT),
        ("supply", "<supply>glue", LONGEST_TEXT),
        ("step", "<step>Glue the motors &amp; wait.", LONGEST_TEXT),
    ],
)
def test_a_text_is_as_long_as_there_is_room_and_one_longer_is_told_with_its_place(
    name: str, before: str, longest: int
) -> None:
    assert GOOD.count(before) == 1
    schema = xmlschema.XMLSchema(schemas.FOLDER / "board.xsd")
    fits, too_long = (GOOD.replace(before, f"<{name}>\n  {'x' * length}  ") for length in (longest, longest + 1))
    assert read(fits)[1] == []
    assert schema.is_valid(fits)
    kit, found = read_kit(too_long.encode(), "mine.board.xml")
    assert kit is None
    line = GOOD[: GOOD.index(before)].count("\n") + 1
    assert [(one.code, one.place and one.place.line) for one in found] == [("xml-long-text", line)]
    assert f"at most {longest} characters in <{name}>, found {longest + 1}" in found[0].message
    assert not schema.is_valid(too_long)


def test_a_language_that_is_not_spoken_is_told_with_its_place_and_the_text_is_kept() -> None:
    kit, found = read_kit(GOOD.replace('<label xml:lang="fr">', '<label xml:lang="tlh">').encode(), "mine.board.xml")
    assert kit is not None
    assert kit.label == {"": "Mine", "tlh": "Le mien"}
    assert [(one.code, one.is_error, one.place and (one.place.line, one.place.column)) for one in found] == [
        ("xml-unknown-language", False, (3, 20))
    ]
    assert f"expected {one_of(LANGUAGES)} in xml:lang, found" in found[0].message
    assert read_kit(write_kit(kit).encode(), "mine.board.xml")[0] == kit


@pytest.mark.parametrize("name", ["label", "help"])
def test_a_text_twice_in_a_language_is_told_with_its_place(name: str) -> None:
    again = f'  <{name} xml:lang="ur">ایک</{name}>\n'
    kit, found = read_kit(GOOD.replace("  <tried", f"{again}{again}  <tried").encode(), "mine.board.xml")
    assert kit is None
    assert [(one.code, one.place and one.place.line) for one in found] == [("xml-duplicate", 6)]


def test_a_file_that_is_cut_anywhere_is_no_kit_and_never_breaks_the_reader() -> None:
    for end in range(0, len(GOOD) - 2, 37):
        kit, found = read(GOOD[:end])
        assert kit is None
        assert found
