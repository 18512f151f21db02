"""`kitrobot diff`: differences in words, and the exit status of `diff`."""

from __future__ import annotations

import pytest

MISSION = """<kitrobot version="1">
  <program name="p" robot="mini-robot">
    <vertex id="start" element="Start"/>
    <vertex id="v1" element="While"/>
    <vertex id="v2" element="Run.IsTrue"/>
    <vertex id="v3" element="Wheel.Advance"><set name="speed">50</set><note>slowly</note></vertex>
    <vertex id="v4" element="Wait"><set name="duration">5</set></vertex>
    <vertex id="stop" element="Stop"/>
    <arc from="start" to="v1"/>
    <arc from="v2" to="v1" at="condition"/>
    <arc from="v1" out="body" to="v3"/>
    <arc from="v3" to="v4"/>
    <arc from="v4" to="v1" at="return"/>
    <arc from="v1" to="stop"/>
  </program>
  <team>
    <agent name="robot-1" program="p"/>
    <goal storehouse="B" stock="all"/>
  </team>
</kitrobot>
"""
SWAPPED = (
    MISSION.replace('out="body" to="v3"', 'out="body" to="v4"')
    .replace('<arc from="v3" to="v4"/>', '<arc from="v4" to="v3"/>')
    .replace('<arc from="v4" to="v1" at="return"/>', '<arc from="v3" to="v1" at="return"/>')
)
ADDED = MISSION.replace(
    '    <vertex id="stop"', '    <vertex id="v9" element="Light.LightOn"/>\n    <vertex id="stop"'
).replace('<arc from="v3" to="v4"/>', '<arc from="v3" to="v9"/>\n    <arc from="v9" to="v4"/>')
NEW = '  <program name="q" robot="mini-robot"/>\n  <team>'


@pytest.fixture
def diff(kitrobot, here):
    def call(before, after, *options, ending=".krt"):
        for name, text in (("a", before), ("b", after)):
            (here / f"{name}{ending}").write_text(text, encoding="utf-8")
        return kitrobot("diff", f"a{ending}", f"b{ending}", *options)

    return call


def test_equal_missions_are_equal_whatever_their_layout(diff):
    for other in (MISSION, MISSION.replace("\n    ", "\n\t").replace("/>", " />")):
        said = diff(MISSION, other)
        assert (said.status, said.out) == (0, "")


@pytest.mark.parametrize(
    ("after", "words"),
    [
        (MISSION.replace(">50<", ">30<"), ["p: the speed of Wheel.Advance (v3): 50 → 30"]),
        (ADDED, ["p: Light.LightOn (v9) added after Wheel.Advance (v3) in the body of While (v1)"]),
        (SWAPPED, ["p: Wait (v4) moved first in the body of While (v1)"]),
        (MISSION.replace("<note>slowly</note>", ""), ["p: the note “slowly” at Wheel.Advance (v3) removed"]),
        (MISSION.replace(">slowly<", ">fast<"), ["p: the note at Wheel.Advance (v3): “slowly” → “fast”"]),
        (MISSION.replace("Wheel.Advance", "Wheel.Reverse"), ["p: Wheel.Advance (v3) became Wheel.Reverse"]),
        (MISSION.replace('robot="mini-robot"', 'robot="carrier"'), ["p: the robot: mini-robot → carrier"]),
        (MISSION.replace("  <team>", NEW), ["the program q added, for the robot mini-robot"]),
        (
            MISSION.replace('name="p"', 'name="q"').replace('program="p"', 'program="q"'),
            ["the program p renamed to q", "the team: the program of robot-1: p → q"],
        ),
        (MISSION.replace("robot-1", "robot-2"), ["the team: robot-1 removed", "the team: robot-2 added, runs p"]),
        (
            MISSION.replace('"all"', '"3"'),
            ["the goals: B holds all removed", "the goals: B holds 3 added"],
        ),
        (
            MISSION.replace("  </team>", '  </team>\n  <world href="ring.world.xml"/>'),
            ["the world: empty → ring.world.xml"],
        ),
    ],
)
def test_each_difference_is_a_sentence(diff, after, words):
    said = diff(MISSION, after)
    assert (said.status, said.out.splitlines()) == (1, words)


def test_what_was_added_one_way_is_removed_the_other(diff):
    said = diff(ADDED, MISSION)
    assert said.out == "p: Light.LightOn (v9) removed, it stood after Wheel.Advance (v3) in the body of While (v1)\n"


def test_json_is_a_list_of_objects(diff):
    assert diff(MISSION, MISSION.replace(">50<", ">30<"), "--json").json == [
        {"kind": "setting", "words": "the speed of Wheel.Advance (v3): 50 → 30", "program": "p", "vertex": "v3"}
    ]
    assert diff(MISSION, MISSION, "--json").json == []


def test_texts_are_compared_in_their_true_layout(diff):
    said = diff("WAIT(1);Light.LightOn();", "WAIT( 1 );\n\nLight.LightOff();\nWAIT(3);", ending=".lll")
    assert said.status == 1
    assert said.out.splitlines() == ["line 2: `Light.LightOn();` → `Light.LightOff();`", "line 3 added: `WAIT(3);`"]
    assert diff("WAIT(1);Light.LightOn();", "WAIT( 1 );\n\nLight.LightOn();", ending=".lll").status == 0


@pytest.mark.parametrize(
    "text", ["", "<kitrobot", "rubbish", MISSION.replace('version="1"', 'version="99"'), MISSION[:-40], "\0"]
)
def test_a_file_that_cannot_be_used_is_trouble(diff, text):
    for said in (diff(MISSION, text), diff(text, MISSION)):
        assert (said.status, said.out) == (2, "")
        assert "error" in said.err


def test_a_missing_file_and_two_kinds_are_trouble(kitrobot, here, program):
    assert kitrobot("diff", "none.krt", "none.krt").status == 2
    (here / "a.krt").write_text(MISSION)
    said = kitrobot("diff", "a.krt", program)
    assert (said.status, "one of each" in said.err) == (2, True)


def test_a_text_with_a_mistake_is_trouble_and_shown(diff):
    said = diff("WAIT(1);", "WAIT(1;", ending=".lll")
    assert said.status == 2
    assert "b.lll:1" in said.err
