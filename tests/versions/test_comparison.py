"""Differences in words: none for equal missions, at least one for others, whatever was edited."""

from __future__ import annotations

import copy

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kitrobot.diagnostics.problems import ProblemsError
from kitrobot.graph.model import Arc, Vertex
from kitrobot.lll.tree import RoleDeclaration, WorkDeclaration
from kitrobot.primitives.levels import Level
from kitrobot.translation.reader_language import override_language, translate
from kitrobot.versions.comparison import differences
from kitrobot.versions.file_comparison import CompareError, compare_files
from kitrobot.versions.mission_merge import merge_missions
from tests.versions.test_merging import base, edited, insert


@given(st.integers(0, 10**6), st.integers(0, 6))
def test_missions_differ_in_words_exactly_when_they_differ(seed, count):
    side = edited(base(), seed, count)
    assert bool(differences(base(), side)) == (side != base())
    assert differences(side, copy.deepcopy(side)) == []


def test_a_graph_that_makes_no_sense_is_compared_all_the_same():
    odd = base()
    program = odd.programs[0]
    program.arcs += [
        Arc("v3", "v3"),
        Arc("none", "v1"),
        Arc("v4", "none", "x", "y"),
        Arc("v8", "v1", "next", "condition"),
    ]
    program.vertices.append(Vertex("v3", "Wait"))
    assert differences(base(), odd)
    assert differences(odd, base())
    assert differences(odd, copy.deepcopy(odd)) == []


def test_the_order_of_arcs_alone_is_told_as_that():
    other = base()
    other.programs[0].arcs.reverse()
    assert [found.kind for found in differences(base(), other)] == ["order"]


def test_one_instruction_put_in_is_one_difference():
    other = base()
    program = other.programs[0]
    program.vertices.insert(-1, Vertex("v9", "Wait", {"duration": "3"}))
    program.arcs[2].target = "v9"
    program.arcs.append(Arc("v9", "v3"))
    words = [found.sentence for found in differences(base(), other)]
    assert words == ["p: Wait (v9) added first in the body of While (v1)"]


def test_what_a_team_declares_is_told_as_its_lines():
    one, other = base(), base()
    one.team.roles = [RoleDeclaration("r", "carrier"), RoleDeclaration("s", "loader", 2, 2)]
    other.team.roles = [RoleDeclaration("r", "carrier", 1, 3)]
    other.team.works = [WorkDeclaration("Boxes", 12, after="all")]
    words = [found.sentence for found in differences(one, other)]
    assert words == [
        "the team: `role s: loader 2` removed",
        "the team: `role r: carrier` → `role r: carrier 1..3`",
        "the team: `work Boxes = 12` added",
    ]
    quiet = copy.deepcopy(other)
    quiet.team.works[0].after = None
    assert [found.kind for found in differences(other, quiet)] == ["note"]


def test_another_level_of_a_program_is_told():
    other = base()
    other.programs[0].level, other.programs[0].target = Level.GROUP, ""
    assert [found.sentence for found in differences(base(), other)] == ["p: the level: agent → group"]
    merged = merge_missions(base(), other, base())
    assert merged.mission.programs[0].level is Level.GROUP


def test_two_parts_that_share_an_id_are_one_gone_and_one_new():
    one, other = base(), base()
    insert(one.programs[0], "v3", "next", "v9", "Light.LightOn")
    insert(other.programs[0], "v8", "next", "v9", duration="3")
    assert [found.sentence for found in differences(one, other)] == [
        "p: Light.LightOn (v9) removed, it stood after Wheel.Advance (v3) in the body of While (v1)",
        "p: Wait (v9) added after Wait (v8)",
    ]


def test_a_part_in_the_place_of_another_is_told_once():
    one, other = base(), base()
    other.programs[0].vertices[4] = Vertex("v4", "Light.LightOff")
    assert [found.sentence for found in differences(one, other)] == ["p: Wait (v4) became Light.LightOff"]


def test_two_kits_are_told_apart_by_parts_settings_and_what_was_measured(tmp_path):
    one, other = tmp_path / "one.board.xml", tmp_path / "other.board.xml"
    head = '<board name="k" version="1" micropython="{}" pins="{}">'
    parts = '<actuator device="turn" rate="180"/><sensor device="sign" driver="marks" pin="1"/>'
    parts += '<actuator device="pen" pin="4"/>'
    one.write_text(head.format("1.20", "0..5") + parts + "</board>")
    parts = (
        '<actuator device="turn" rate="150" bus="1"/><sensor device="sign" driver="line" pin="1"/>'
        '<missing kind="actuator" device="pen"/><actuator device="lamp" driver="led" pin="2"/>'
        '<measured device="drive" speed="300"/>'
    )
    other.write_text(head.format("1.25", "0..6") + parts + "</board>")
    assert compare_files(one, one) == []
    assert [(found.kind, found.words) for found in compare_files(one, other)] == [
        ("board", "the kit: its pins changed"),
        ("board", "the kit: micropython 1.20 → 1.25"),
        ("setting", "the kit: actuator turn: rate 180 → 150"),
        ("setting", "the kit: actuator turn: bus – → 1"),
        ("part", "the kit: sensor sign has another driver: marks → line"),
        ("part", "the kit: actuator pen is missing now"),
        ("setting", "the kit: actuator pen: pin 4 → –"),
        ("part", "the kit: actuator lamp added"),
        ("measured", "the kit: drive as measured: speed – → 300"),
    ]
    with pytest.raises(CompareError, match="two kits"):
        compare_files(one, tmp_path / "mission.krt")
    other.write_text("<board/>")
    with pytest.raises(ProblemsError):
        compare_files(one, other)


def test_texts_of_two_kits_are_told_apart_language_by_language(tmp_path):
    one, other = tmp_path / "one.board.xml", tmp_path / "other.board.xml"
    kit = (
        '<board name="k" version="1"><label>Tank</label>{}<missing device="range"><help>No.</help>{}</missing></board>'
    )
    one.write_text(kit.format("", ""))
    other.write_text(kit.format('<label xml:lang="fr">Char</label>', '<help xml:lang="ur">نہیں۔</help>'))
    found = compare_files(one, other)
    assert [(one.kind, one.words) for one in found] == [
        ("board", "the kit: its label in French changed"),
        ("part", "the kit: sensor range: its help in Urdu changed"),
    ]
    with override_language("fr"):
        assert [translate(one.words) for one in found] == [
            "le kit : titre en français a changé",
            "le kit : sensor range : aide en ourdou a changé",
        ]
