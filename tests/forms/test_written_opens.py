"""Whatever is written opens: odd but accepted files come back as they were read, without new problems."""

from __future__ import annotations

import random
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kitrobot.diagnostics.model import Diagnostic
from kitrobot.lll.parse_results import parse
from kitrobot.lll.printer import print_program
from kitrobot.mission.reader import read_mission
from kitrobot.mission.writer import write_mission
from kitrobot.primitives.constructors_xml import read_constructors
from kitrobot.primitives.own_xml import write_constructors
from kitrobot.world.xml_reader import read_world
from kitrobot.world.xml_writer import write_world
from tests.effort import examples

ROOT = Path(__file__).resolve().parents[2]
SHIPPED = ROOT / "src" / "kitrobot"
Read = Callable[[bytes, str], tuple[Any, list[Diagnostic]]]


def constructors(data: bytes, name: str) -> tuple[Any, list[Diagnostic]]:
    groups, found = read_constructors(data, name)
    return [one for group in groups for one in group.constructors], found


FULL = """<kitrobot version="1">
  <label>Full</label>
  <label xml:lang="fr">Plein</label>
  <help>Everything that a mission may hold.</help>
  <constructor name="Twice" icon="repeat" colour="loop">
    <label xml:lang="ur">دو بار</label>
    <number name="count" min="1" max="9" default="2"/>
    <flow name="body" loop="yes"/>
    <code>{count}*({body})</code>
  </constructor>
  <variable name="Laps" robot="mini-robot" type="integer" min="0" max="9" initial="1"/>
  <program name="p" robot="mini-robot">
    <vertex id="start" element="Start"/>
    <vertex id="v1" element="Wait"><set name="duration">2</set><note>slowly</note></vertex>
    <vertex id="stop" element="Stop"/>
    <arc from="start" to="v1"/>
    <arc from="v1" to="stop"/>
    <note at="v1">by hand</note>
  </program>
  <program name="haul" level="group">
    <vertex id="start" element="Start"/>
    <vertex id="v1" element="Program"><set name="name">p</set></vertex>
    <vertex id="stop" element="Stop"/>
    <arc from="start" to="v1"/>
    <arc from="v1" to="stop"/>
  </program>
  <team>
    <agent name="a" program="p" start="b"/>
    <goal storehouse="A" stock="all"/>
    <goal storehouse="B" stock="12"/>
    <role name="r" robot="mini-robot" least="0" most="3"><note>who&#10;then</note><note at="after">few</note></role>
    <group name="g" members="r a &quot;b c&quot;" failure="substitute"><note>all</note></group>
    <work name="Boxes" units="12" lease="30"/>
  </team>
  <breakpoint program="p" vertex="v1" every="yes" when="Laps.EqualTo(1)" hits="2" off="yes">
    <agent name="a"/>
  </breakpoint>
  <failure agent="a" at="1.5" kind="stall"/>
  <property name="low" never="any a (Laps.EqualTo(9) &amp; Laps.EqualTo(8))"/>
  <property name="up" after="any a (Laps.EqualTo(1))" eventually="all p (Laps.EqualTo(2))"/>
  <world version="1" name="own" width="1000" height="800.5">
    <wall x1="0" y1="0" x2="10" y2="10"/>
    <storehouse name="A" x="100" y="100" width="50" height="50" capacity="9" stock="3"/>
    <start name="a" x="10" y="20" heading="90"/>
    <later x="1"/>
  </world>
  <later a="1"><inner/>text</later>
</kitrobot>
"""
KINDS: dict[str, tuple[Read, Callable[[Any], bytes], list[str]]] = {
    "mission": (
        read_mission,
        write_mission,
        [FULL, *(path.read_text() for path in sorted((ROOT / "examples").glob("*/*.krt"))[:6])],
    ),
    "world": (read_world, write_world, [path.read_text() for path in sorted(SHIPPED.rglob("*.world.xml"))]),
    "constructors": (
        constructors,
        write_constructors,
        [
            "<constructors version='1'><group name='Own'>"
            + FULL[FULL.index("  <constructor") : FULL.index("  <variable")]
            + "</group></constructors>"
        ],
    ),
}
ODD = (
    *(
        "",
        " ",
        "0",
        "00",
        "07",
        "00000000000000000007",
        "+1",
        "-0",
        "1.",
        ".5",
        "1e2",
        "1e308",
        "1e-9",
        "0.0004",
        "0.0005",
        "9" * 5000,
    ),
    *("²", "٣", "１", "½", "NaN", "inf", "true", "yes", "all", "1_0", "0x1", "65535", "65536", "999999999999999999"),
    *(
        "é",
        "☂",
        "e\u0301",
        "a b",
        " a ",
        "a\u00a0b",
        "\u202eabc",
        "\ud83d\ude00",
        "&amp;",
        "&lt;x&gt;",
        "&#10;",
        "&#9;",
    ),
    *(
        "&quot;",
        "{x}",
        "{",
        "`",
        "'",
        "a:b",
        "--",
        "]]&gt;",
        "\u2028",
        "\ufeff",
        "x" * 500,
        "../x",
        "C:\\x",
        "~",
        "\x85",
    ),
)
INSIDE = (
    "<later/>",
    '<later a="&quot;&#10;">x<b xml:space="preserve"> </b></later>',
    "<!-- a note -->",
    "<?target data?>",
    "<![CDATA[<x>]]>",
    '<l:later xmlns:l="urn:x" l:a="1"><l:b/></l:later>',
    "<note>a&#13;b&#9;c</note>",
    "<help xml:lang='fr'> two\n lines </help>",
    "<label></label>",
    "text",
    "&#x1F600;",
)
_VALUE = re.compile(r'(?<==)"[^"]*"')
_TEXT = re.compile(r"(?<=>)[^<>]+(?=<)")
_END = re.compile(r"(?=</)|(?<=/>)")


def bent(text: str, rng: random.Random) -> str:
    """The file with one to three odd things in it."""
    for _ in range(rng.randint(1, 3)):
        way = rng.random()
        places = list((_VALUE if way < 0.5 else _TEXT if way < 0.65 else _END).finditer(text))
        if not places:
            continue
        place = rng.choice(places)
        if way < 0.5:
            odd = rng.choice(ODD).replace('"', "")
            put = f'"{odd}"' if rng.random() < 0.8 else f'"{odd}" later="{odd}"'
        else:
            put = rng.choice(ODD if way < 0.65 else INSIDE)
        text = text[: place.start()] + put + text[place.end() :]
    return text


def expect_written_opens(kind: str, text: str) -> None:
    read, write, _ = KINDS[kind]
    value, problems = read(text.encode("utf-8", "replace"), "odd.xml")
    if value is None:
        return
    data = write(value)
    again, found = read(data, "odd.xml")
    assert again == value, data.decode()
    assert write(again) == data
    before = [(problem.code, problem.message) for problem in problems]
    new = [problem for problem in found if (problem.code, problem.message) not in before]
    assert new == [], data.decode()


@pytest.mark.parametrize("kind", list(KINDS))
def test_what_is_shipped_is_read_as_it_is_written(kind: str) -> None:
    for text in KINDS[kind][2]:
        expect_written_opens(kind, text)


@pytest.mark.parametrize("kind", list(KINDS))
@given(st.randoms(use_true_random=False), st.data())
@settings(max_examples=examples(20))
def test_what_is_odd_is_read_as_it_is_written(kind: str, rng: random.Random, data: st.DataObject) -> None:
    text = data.draw(st.sampled_from(KINDS[kind][2]))
    for _ in range(5):
        expect_written_opens(kind, bent(text, rng))


@pytest.mark.parametrize("odd", ODD)
def test_a_version_is_read_the_same_by_whoever_reads_it(odd: str) -> None:
    for kind in ("mission", "world"):
        for text in KINDS[kind][2][:1]:
            expect_written_opens(kind, text.replace('version="1"', f'version="{odd}"', 1))


@given(st.randoms(use_true_random=False))
def test_a_text_with_odd_numbers_is_printed_as_it_is_read(rng: random.Random) -> None:
    words = [*ODD, "Motor.Turn(", "3*(", "WAIT(", ")", ");", ";", ",", "Count.Add(1);", "//(", "°Wheel.Stop()°"]
    text = " ".join(rng.choice(words) for _ in range(rng.randint(1, 8)))
    parsed = parse(text, "odd.lll")
    if not any(one.is_error for one in parsed.diagnostics):
        printed = print_program(parsed.program)
        again = parse(printed, "odd.lll")
        assert not any(one.is_error for one in again.diagnostics)
        assert print_program(again.program) == printed
