"""A part's LLL as a person edits it; and its template as a graph."""

from __future__ import annotations

import random

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kitrobot.compiler.graph.own_part import Appearance, ChosenSlot, PartError, make_part, offer_part
from kitrobot.compiler.text.lll_to_graph import lll_to_graph
from kitrobot.compiler.text.part_text import draw_template, read_part
from kitrobot.primitives.constructors import Constructor, Role, Slot, SlotKind
from tests.compiler.graphs import shipped
from tests.strategies import Shape, random_program, shipped_robots

ROBOT = shipped().robot("mini-robot")


def part(code: str, *slots: Slot) -> Constructor:
    return Constructor("Own", "Own", "action", slots, code, None, Role.INSTRUCTION)


def slots_of(code: str, *slots: Slot) -> list[tuple[str, str, int | None, int | None, str]]:
    read = read_part(part(code, *slots), ROBOT)
    assert read.constructor is not None, read.diagnostics
    return [(one.name, str(one.kind), one.minimum, one.maximum, one.default) for one in read.constructor.slots]


def test_slots_follow_the_holes() -> None:
    assert slots_of("{n}*( Wheel.Advance({speed}); {body}; *[{c}](°{act}°; ); WAIT({n}); );") == [
        ("n", "number", None, None, ""),
        ("speed", "value", 0, 100, "50"),
        ("body", "flow", None, None, ""),
        ("c", "condition", None, None, ""),
        ("act", "action", None, None, ""),
    ]


def test_a_slot_that_is_there_stays_as_long_as_it_fits() -> None:
    speed = Slot("speed", SlotKind.NUMBER, minimum=5, maximum=50, default="9", label={"": "How fast"})
    gone = Slot("gone", SlotKind.CONDITION)
    assert slots_of("Wheel.Advance({speed}); WAIT({more});", gone, speed) == [
        ("speed", "number", 5, 50, "9"),
        ("more", "number", None, None, ""),
    ]
    read = read_part(part("*[{speed}]( Wheel.Stop(); )", speed), ROBOT)
    assert read.constructor is not None
    assert [(one.kind, one.label) for one in read.constructor.slots] == [("condition", {"": "How fast"})]


def test_a_value_that_is_used_twice_can_only_be_typed() -> None:
    assert [one[1] for one in slots_of("Wheel.Advance({s}); Wheel.Reverse({s});")] == ["number"]


def test_its_text_comes_back_in_the_one_true_layout_without_comments() -> None:
    read = read_part(part("# hello\nWheel.Stop(); # there\n *[ {c} ]( WAIT( 3 );)"), ROBOT)
    assert read.lll == "Wheel.Stop();\n*[{c}]( WAIT(3); );\n"
    assert read.constructor is not None
    assert read.constructor.code == "Wheel.Stop(); *[{c}]( WAIT(3); );"


@pytest.mark.parametrize(
    ("code", "line", "column", "words"),
    [
        ("Wheel.Stop();\n*[{c}(WAIT(1));", 2, 6, "expected"),
        ("", 1, 1, "empty"),
        ("{a}", 1, 1, "only a hole"),
        ("*[{c} & {c}]( Wheel.Stop(); );\nWheel.Stop();", 1, 9, "twice"),
        ("Wheel.Stop();\n<{b}>( {b}; );", 2, 8, "stands there twice"),
    ],
)
def test_mistakes_have_their_place_in_the_text(code: str, line: int, column: int, words: str) -> None:
    read = read_part(part(code), ROBOT)
    assert read.constructor is None
    problem = read.diagnostics[0]
    assert words in problem.message
    assert problem.place is not None
    assert (problem.place.line, problem.place.column) == (line, column)


def test_a_range_that_cannot_be_is_told_without_a_place() -> None:
    speed = Slot("speed", SlotKind.VALUE, minimum=50, maximum=5)
    read = read_part(part("Wheel.Advance({speed});", speed), ROBOT)
    assert read.constructor is None
    assert [(one.place, "min" in one.message) for one in read.diagnostics] == [(None, True)]


def test_a_template_is_drawn_with_its_holes() -> None:
    read = read_part(part("{n}*( Wheel.Advance({speed}); {body}; *[{c}](°{act}°; ); );"), ROBOT)
    assert read.constructor is not None
    drawn = draw_template(read.constructor, ROBOT, shipped())
    assert [(one.element, one.settings) for one in drawn.vertices] == [
        ("Start", {}),
        ("Repetition", {"count": "{n}"}),
        ("Wheel.Advance", {"speed": "{speed}"}),
        ("{body}", {}),
        ("While", {}),
        ("{c}", {}),
        ("Interrupt", {}),
        ("{act}", {}),
        ("Stop", {}),
    ]


def test_a_condition_is_drawn_alone() -> None:
    read = read_part(part("Run.IsTrue() & !({c})"), ROBOT)
    assert read.constructor is not None
    drawn = draw_template(read.constructor, ROBOT, shipped())
    assert sorted(one.element for one in drawn.vertices) == ["And", "No", "Run.IsTrue", "{c}"]


@given(st.randoms(use_true_random=True))
def test_any_part_that_can_be_made_reads_again_and_is_drawn(rng: random.Random) -> None:
    robot = rng.choice(list(shipped_robots().values()))
    program = lll_to_graph(random_program(rng, robot, Shape(instructions=8, depth=3)), robot, shipped(), "p")
    vertices = [one.id for one in program.vertices][1:-1]
    top = [arc.target for arc in program.arcs if arc.at == "in" and arc.target in vertices][:1]
    if not top:
        return
    offers = [one for one in offer_part(program, top, shipped()).offers if rng.random() < 0.3]
    chosen = [ChosenSlot(one.vertex, one.slot, f"{one.name}_{index}") for index, one in enumerate(offers)]
    try:
        made = make_part(program, top, Appearance("Own"), chosen, shipped()).constructor
    except PartError:
        return
    assert read_part(made, robot).constructor == made
    drawn = draw_template(made, robot, shipped())
    shown = {one.element for one in drawn.vertices} | {text for one in drawn.vertices for text in one.settings.values()}
    assert {f"{{{slot.name}}}" for slot in made.slots} <= shown
