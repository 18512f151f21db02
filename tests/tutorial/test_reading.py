"""A tutorial is read whole, or its mistake is said with its place. Damaged XML: tests/primitives/test_bad_xml.py."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

import pytest
import xmlschema

import kitrobot.primitives
from kitrobot.lll.parse_results import parse
from kitrobot.lll.tree import Call, Repeat, While
from kitrobot.tutorial.model import EVENTS, GroupWant, Point, SpareWant
from kitrobot.tutorial.pattern_matcher import steps_fit
from kitrobot.tutorial.tutorial_xml import BUTTONS, DEEPEST_PATTERN, MOST_STEPS, PANELS, read_tutorial
from tests.primitives.samples import TUTORIAL, messages


@cache
def schema() -> xmlschema.XMLSchema:
    return xmlschema.XMLSchema(Path(kitrobot.primitives.__file__).parent / "schemas" / "tutorial.xsd")


def tutorial(inside: str, start: str = "x.krt") -> str:
    """A file of one step."""
    head = f'<tutorial version="1" start="{start}"><label>T</label>'
    return f"{head}<step><label>S</label>{inside}</step></tutorial>"


def test_a_tutorial_is_read_with_everything_in_it() -> None:
    found, problems = read_tutorial(TUTORIAL.encode(), "x.tutorial.xml")
    assert problems == []
    assert found is not None
    assert (found.start, found.label, found.icon) == ("x.krt", {"": "First steps ✓"}, "graduation-cap")
    [step] = found.steps
    assert step.help == {"": "Drag Advance onto the line < here."}
    assert step.points == (Point("part", "Wheel.Advance"),)
    assert step.events == ("run-done",)
    [[pattern]] = step.wants
    assert isinstance(pattern.code, While)
    assert (pattern.whole, pattern.program, pattern.programs) == (False, "", 1)
    assert pattern.ranges == {"speed": (30, 65535)}
    schema().validate(TUTORIAL)


def test_several_right_ways_and_several_wants_are_told_apart() -> None:
    text = tutorial(
        "<any><contains><code>4*({b})</code></contains><matches><code>Wheel.Stop()</code></matches></any>"
        '<contains programs="2"><code>Wheel.Stop()</code></contains>'
        '<matches program="b"><code>Wheel.Stop()</code></matches>'
    )
    found, problems = read_tutorial(text.encode(), "x")
    schema().validate(text)
    assert found is not None
    assert problems == []
    either, both, other = found.steps[0].wants
    assert isinstance(either[0].code, Repeat)
    assert isinstance(either[1].code, Call)
    assert [pattern.whole for pattern in (*either, *both, *other)] == [False, True, False, True]
    assert (both[0].programs, other[0].program) == (2, "b")


@pytest.mark.parametrize("name", EVENTS)
def test_every_event_can_be_waited_for(name: str) -> None:
    text = tutorial(f'<event name="{name}"/>')
    assert messages(read_tutorial, text) == []
    schema().validate(text)


@pytest.mark.parametrize(
    ("kind", "name"), [*(("button", name) for name in BUTTONS), *(("panel", name) for name in PANELS)]
)
def test_everything_of_the_page_that_has_a_name_can_be_pointed_at(kind: str, name: str) -> None:
    text = tutorial(f'<point {kind}="{name}"/>')
    assert messages(read_tutorial, text) == []
    schema().validate(text)


def test_what_is_wanted_of_a_team_and_a_point_into_a_group_are_read() -> None:
    text = tutorial(
        '<group failure="drop" name="crew"/><group failure="abort"/><spare/><spare robots="2"/>'
        '<point group="crew" failure="substitute"/><point group="crew"/>'
    )
    found, problems = read_tutorial(text.encode(), "x")
    schema().validate(text)
    assert problems == []
    assert found is not None
    [step] = found.steps
    assert step.team == (GroupWant("drop", "crew"), GroupWant("abort"), SpareWant(), SpareWant(2))
    assert step.points == (Point("group", "crew", "substitute"), Point("group", "crew"))


MISTAKES = [
    (
        "<contains><code>4*(</code></contains>",
        "( | not-closed | this `(` is never closed",
    ),
    ("<contains><code>{x}</code></contains>", "<code | constructor-template | expected LLL around the hole"),
    ("<contains></contains>", "<contains | tutorial-pattern | expected one <code> in <contains>, found 0"),
    (
        "<contains><code>WAIT(1)</code><code>WAIT(2)</code></contains>",
        "<contains | tutorial-pattern | expected one <code> in <contains>, found 2",
    ),
    (
        '<contains><code>WAIT({time})</code><hole name="tiem"/></contains>',
        "tiem | tutorial-pattern | the code has no hole {tiem}",
    ),
    (
        '<contains><code>WAIT({d})</code><hole name="d"/><hole name="d"/></contains>',
        "d | tutorial-pattern | the range of {d} is given already",
    ),
    (
        '<contains><code>WAIT({d})</code><hole name="d" min="9" max="3"/></contains>',
        "9 | tutorial-pattern | expected min at most max, found 9 and 3",
    ),
    (
        '<contains><code>WAIT({d})</code><hole name="d" max="65536"/></contains>',
        "65536 | xml-bad-value | expected a whole number from 0 to 65535 in max",
    ),
    (
        '<contains program="a" programs="2"><code>WAIT(1)</code></contains>',
        "2 | tutorial-pattern | expected either program or programs, found both",
    ),
    ("<any></any>", "<any | tutorial-pattern | expected <contains> or <matches> in <any>, found none"),
    ('<event name="run-starts"/>', "run-starts | xml-bad-value | expected run-started, run-done,"),
    (
        "<point/>",
        "<point | tutorial-point | expected part, vertex, button, panel, program or group on <point>, found none",
    ),
    (
        '<point part="a" vertex="b"/>',
        "<point | tutorial-point | expected part, vertex, button, panel, program or group",
    ),
    ('<point part="a" slot="b"/>', "b | tutorial-point | expected no slot here, found one"),
    ('<point vertex="a" slot="b" setting="c"/>', "b | tutorial-point | expected no slot here, found one"),
    ('<point group="a" slot="b"/>', "b | tutorial-point | expected no slot here, found one"),
    ('<point vertex="a" failure="drop"/>', "drop | tutorial-point | expected no failure here, found one"),
    ('<group failure="help"/>', "help | xml-bad-value | expected drop, substitute or abort"),
    ('<spare robots="0"/>', "0 | xml-bad-value | expected a whole number from 1 to 100"),
    ('<point button="stpo"/>', "stpo | xml-bad-value | expected run,"),
]


@pytest.mark.parametrize(("inside", "said"), MISTAKES, ids=[inside for inside, _ in MISTAKES])
def test_a_mistake_is_said_at_its_place_and_the_tutorial_is_not_used(inside: str, said: str) -> None:
    text = tutorial(inside)
    assert read_tutorial(text.encode(), "f.xml")[0] is None
    [message] = messages(read_tutorial, text)
    place, code, sentence = said.split(" | ")
    found_place, found_code, found_sentence = message.split(" | ")
    assert (found_place, found_code) == (place, code)
    assert found_sentence.startswith(sentence)


@pytest.mark.parametrize("start", ["", "../x.krt", "a/b.krt", "C:x.krt", "x.xml", ".krt", "x\\y.krt"])
def test_the_start_is_a_file_of_the_same_folder(start: str) -> None:
    assert read_tutorial(tutorial("", start).encode(), "f.xml")[0] is None
    assert not schema().is_valid(tutorial("", start))


def test_a_tutorial_needs_names_and_steps_within_the_limit() -> None:
    step = "<step><label>S</label></step>"
    head = '<tutorial version="1" start="x.krt"><label>T</label>'
    assert read_tutorial(f"{head}{step * MOST_STEPS}</tutorial>".encode(), "f")[0] is not None
    assert read_tutorial(f"{head}{step * (MOST_STEPS + 1)}</tutorial>".encode(), "f")[0] is None
    assert read_tutorial(f"{head}</tutorial>".encode(), "f")[0] is None
    assert read_tutorial(f"{head}<step/></tutorial>".encode(), "f")[0] is None
    assert read_tutorial(f'<tutorial version="1" start="x.krt">{step}</tutorial>'.encode(), "f")[0] is None


def test_a_pattern_is_nested_up_to_the_limit() -> None:
    def nested(levels: int) -> str:
        # Each loop is two levels, itself and its body; the wait is one.
        return tutorial(f"<contains><code>{'2*(' * levels}WAIT(1){')' * levels}</code></contains>")

    within = (DEEPEST_PATTERN - 1) // 2
    assert read_tutorial(nested(within).encode(), "f")[0] is not None
    assert read_tutorial(nested(within + 1).encode(), "f")[0] is None


def test_the_example_of_the_docs_is_right_and_a_program_can_do_it() -> None:
    page = (Path(__file__).parents[2] / "docs" / "tutorials.md").read_text(encoding="utf-8")
    [example] = re.findall(r"```xml\n(.*?)```", page, re.DOTALL)
    schema().validate(example)
    found, problems = read_tutorial(example.encode(), "tutorials.md")
    assert found is not None
    assert problems == []
    text = "3*(Light.LightOn(); WAIT(5); Light.LightOff(); WAIT(5));"
    assert steps_fit(found, {"blink": parse(text).program}) == [True, True, True]
    assert steps_fit(found, {"blink": parse(text.replace("5", "6")).program}) == [True, False, True]


def test_the_docs_name_everything_that_can_be_pointed_at_and_every_event() -> None:
    page = (Path(__file__).parents[2] / "docs" / "tutorials.md").read_text(encoding="utf-8")
    for name in (*BUTTONS, *PANELS, *EVENTS):
        assert f"`{name}`" in page, name
