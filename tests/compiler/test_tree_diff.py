"""A graph drawn anew from its edited text: what did not change keeps its vertex, and it says what the text says."""

from __future__ import annotations

import copy
import random
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kitrobot.compiler.graph.graph_to_lll import graph_to_lll
from kitrobot.compiler.text.lll_to_graph import lll_to_graph
from kitrobot.graph.model import Arc, Note, Program, Vertex
from kitrobot.lll.parse_results import parse
from kitrobot.lll.printer import print_program
from kitrobot.lll.tree import MAX_NUMBER, Call, Event, Number, Repeat, Seq, Wait
from kitrobot.lll.walk import nodes
from kitrobot.primitives.catalogue import Catalogue
from tests.compiler.graphs import graph, noted, shipped, with_constructors
from tests.strategies import Shape, random_program, shipped_robots

ROBOT = shipped().robots["mini-robot"]


def drawn(text: str) -> Program:
    return lll_to_graph(parse(text).program, ROBOT, shipped(), "p")


def edited(program: Program, text: str, catalogue: Catalogue | None = None) -> Program:
    """The graph after its text became `text`; it must say that very text."""
    parsed = parse(text)
    assert parsed.diagnostics == []
    known = catalogue or shipped()
    result = lll_to_graph(parsed.program, known.robots[program.target], known, program.name, program)
    assert graph_to_lll(result, known).program == parsed.program
    ids = [vertex.id for vertex in result.vertices]
    assert len(ids) == len(set(ids))
    return result


def elements(program: Program) -> dict[str, str]:
    return {vertex.id: vertex.element for vertex in program.vertices if vertex.element not in ("Start", "Stop")}


def renamed(rng: random.Random, program: Program) -> Program:
    """The same graph with ids that are in no order."""
    numbers = list(range(1, len(program.vertices) + 1))
    rng.shuffle(numbers)
    names = {vertex.id: f"v{number}" for vertex, number in zip(program.vertices, numbers, strict=True)}
    vertices = [replace(vertex, id=names[vertex.id]) for vertex in program.vertices]
    arcs = [replace(arc, source=names[arc.source], target=names[arc.target]) for arc in program.arcs]
    return replace(program, vertices=vertices, arcs=arcs)


# ---- properties ----------------------------------------------------------------------------------------------------


def some_program(rng: random.Random) -> tuple[Program, Seq]:
    robot = rng.choice([*shipped_robots().values()])
    text = print_program(random_program(rng, robot, Shape(rng.choice((3, 10, 25)), 6, comments=True)))
    program = parse(text).program
    return renamed(rng, lll_to_graph(program, robot, shipped(), "p")), program


def draw(seq: Seq, keep: Program) -> Program:
    result = lll_to_graph(seq, shipped().robots[keep.target], shipped(), "p", keep)
    assert graph_to_lll(result, shipped()).program == seq
    return result


@given(st.randoms(use_true_random=True))
def test_the_same_text_gives_the_same_graph(rng: random.Random) -> None:
    program, seq = some_program(rng)
    assert draw(seq, program) == program


@given(st.randoms(use_true_random=True))
def test_a_new_instruction_leaves_all_others_their_vertices(rng: random.Random) -> None:
    program, seq = some_program(rng)
    # What waits for an event and does nothing then is another element.
    waits = {id(node.body) for node in nodes(seq) if isinstance(node, Event) and not node.body.items}
    body = rng.choice([node for node in nodes(seq) if isinstance(node, Seq) and id(node) not in waits])
    body.items.insert(rng.randrange(len(body.items) + 1), Repeat(MAX_NUMBER, Seq()))
    before, after = elements(program), elements(draw(seq, program))
    assert {name: after.get(name) for name in before} == before
    assert [after[name] for name in after if name not in before] == ["Repetition"]


@given(st.randoms(use_true_random=True))
def test_a_changed_number_leaves_every_vertex(rng: random.Random) -> None:
    program, seq = some_program(rng)
    numbers = [node for node in nodes(seq) if isinstance(node, Number)]
    if not numbers:
        return
    rng.choice(numbers).value = MAX_NUMBER - 1
    after = draw(seq, program)
    assert elements(after) == elements(program)
    changed = [
        one.id
        for one, other in zip(program.vertices, after.vertices, strict=True)
        if one.id != other.id or one != other
    ]
    assert len(changed) <= 1
    assert {arc_key(arc) for arc in after.arcs} == {arc_key(arc) for arc in program.arcs}


def arc_key(arc: Arc) -> tuple[str, str, str, str]:
    return arc.source, arc.out, arc.target, arc.at


@given(st.randoms(use_true_random=True))
def test_deleted_instructions_take_no_other_vertex_along(rng: random.Random) -> None:
    program, seq = some_program(rng)
    bodies = [node for node in nodes(seq) if isinstance(node, Seq) and len(node.items) > 1]
    if not bodies:
        return
    body = rng.choice(bodies)
    del body.items[rng.randrange(len(body.items))]
    before, after = elements(program), elements(draw(seq, program))
    assert after.items() <= before.items()


@given(st.randoms(use_true_random=True))
def test_wrapping_in_a_loop_and_unwrapping_keep_every_vertex(rng: random.Random) -> None:
    program, seq = some_program(rng)
    body = rng.choice([node for node in nodes(seq) if isinstance(node, Seq)])
    first = rng.randrange(len(body.items) + 1)
    last = rng.randrange(first, len(body.items) + 1)
    plain = copy.deepcopy(seq)
    body.items[first:last] = [Repeat(MAX_NUMBER, Seq(body.items[first:last]))]
    wrapped = draw(seq, program)
    before, after = elements(program), elements(wrapped)
    unwrapped = elements(draw(plain, wrapped))
    assert before.keys() <= after.keys()
    assert len(after) == len(before) + 1
    assert unwrapped.keys() == before.keys()
    if body.items[1:] or last > first:  # a part with nothing in it may be another one when it holds something
        assert before.items() <= after.items()
        assert unwrapped == before


@given(st.randoms(use_true_random=True))
def test_any_text_over_any_graph_means_what_the_text_says(rng: random.Random) -> None:
    program, _ = some_program(rng)
    robot = shipped().robots[program.target]
    other = parse(print_program(random_program(rng, robot, Shape(10, 4, comments=True)))).program
    result = draw(other, program)
    fresh = {name for name in elements(result) if name not in elements(program)}
    taken = {vertex.id for vertex in program.vertices}
    assert fresh.isdisjoint(taken)


# ---- by hand -------------------------------------------------------------------------------------------------------


def test_swapped_instructions_keep_their_vertices() -> None:
    program = drawn("Wheel.Stop(); Door.Open(); Light.LightOn();")
    after = edited(program, "Light.LightOn(); Wheel.Stop(); Door.Open();")
    assert elements(after) == elements(program)


def test_new_ids_come_after_all_that_exist_even_in_arcs_that_lead_nowhere() -> None:
    program = drawn("Wheel.Stop();")
    program.arcs.append(Arc("v9", "v1", at="x"))
    after = edited(program, "Wheel.Stop(); Door.Open();")
    assert [vertex.id for vertex in after.vertices] == ["start", "v1", "v10", "stop"]


def test_a_changed_element_keeps_its_place() -> None:
    after = edited(drawn("Wheel.Advance(7); Door.Open();"), "Wheel.Stop(); Door.Open();")
    assert after.vertices[1] == Vertex("v1", "Wheel.Stop")


def test_a_choice_that_gets_an_else_keeps_its_vertex() -> None:
    program = drawn("[Run.IsTrue()](Wheel.Stop();)")
    after = elements(edited(program, "[Run.IsTrue()](Wheel.Stop();)!(Door.Open();)"))
    assert after == {"v1": "If Then Else", "v2": "Run.IsTrue", "v3": "Wheel.Stop", "v4": "Door.Open"}


def test_a_condition_that_is_joined_keeps_its_vertex() -> None:
    program = drawn("[Run.IsTrue()]()")
    after = elements(edited(program, "[Flag.IsTrue() & !(Run.IsTrue())]()"))
    assert (after["v1"], after["v2"]) == ("If Then", "Run.IsTrue")
    assert elements(edited(drawn("[Flag.IsTrue() & !(Run.IsTrue())]()"), "[Run.IsTrue()]()"))["v5"] == "Run.IsTrue"


BIG = [
    ("Forever", "", "*(Wheel.Stop();{});"),
    ("Repeat Until", "c:Run.IsTrue > v1.condition", "*[!(Run.IsTrue())](Wheel.Stop();{});"),
    ("Unless", "c:Run.IsTrue > v1.condition", "[!(Run.IsTrue())](Wheel.Stop();{});"),
]


@pytest.mark.parametrize(("element", "condition", "text"), BIG)
def test_a_constructor_of_more_than_one_construct_lives_through_edits_inside_and_around_it(
    element: str, condition: str, text: str
) -> None:
    flow = "then" if element == "Unless" else "body"
    lines = [f"start > v1:{element.replace(' ', '_')} > stop", f"v1.{flow} > w:Wheel.Stop > v1.return"]
    program = graph(*lines, *([condition] if condition else []))
    assert edited(program, text.format("")) == program
    for after in (
        edited(program, "Light.LightOn(); " + text.format("")),
        edited(program, text.format("Door.Open();")),
        edited(program, "2*(" + text.format("") + ");"),
    ):
        assert elements(after)["v1"] == element
        assert elements(after)["w"] == "Wheel.Stop"


def test_a_constructor_whose_template_is_broken_becomes_what_the_text_says() -> None:
    program = graph("start > v1:Wait_Until > stop", "c:Run.IsTrue > v1.condition")
    after = edited(program, "<Run.IsTrue()>(Wheel.Stop(););")
    assert elements(after) == {"v1": "When", "c": "Run.IsTrue", "v2": "Wheel.Stop"}


def test_a_comment_inside_a_template_dissolves_it() -> None:
    own = '<number name="n" min="1" max="9"/><code>Wheel.Advance({n}); WAIT(2);</code>'
    catalogue = with_constructors(f'<constructor name="Dance">{own}</constructor>')
    program = graph("start > v1:Dance n=5 > stop")
    assert edited(program, "Wheel.Advance(5); WAIT(2);", catalogue) == program
    kept = edited(program, "Door.Open(); Wheel.Advance(7); WAIT(2); Door.Close();", catalogue)
    assert [(vertex.id, vertex.settings) for vertex in kept.vertices if vertex.element == "Dance"] == [
        ("v1", {"n": "7"})
    ]
    for text in ("Wheel.Advance(5); # here\nWAIT(2);", "Wheel.Advance(10); WAIT(2);", "Wheel.Advance(5); WAIT(3);"):
        assert "Dance" not in elements(edited(program, text, catalogue)).values()


def test_parked_chains_and_what_nobody_knows_stay() -> None:
    program = graph(
        "start > a:Wheel.Stop > stop",
        "p:Repetition > q:Door.Open",
        "p.body > r:Light.LightOn > p.return",
        "u:Own_Part > w:Gripper.Grab",
    )
    program.vertices[-1].unknown = "<x/>"
    parked = [vertex for vertex in program.vertices if vertex.id in "pqruw"]
    after = edited(program, "Door.Close();")
    assert [vertex for vertex in after.vertices if vertex.id in "pqruw"] == parked
    assert {arc_key(arc) for arc in program.arcs if arc.source in "pqru"} <= {arc_key(arc) for arc in after.arcs}


def test_empty_branches_stay_between_their_neighbours_and_take_new_ones() -> None:
    program = graph(
        "start > v1:Parallelism > stop",
        "v1.branch.1 > v1.return",
        "v1.branch.2 > a:Wheel.Stop > v1.return",
        "v1.branch.3 > v1.return",
    )
    after = edited(program, "//(Wheel.Stop(); Door.Open();); ")
    assert [(arc.out, arc.target) for arc in after.arcs if arc.source == "v1"] == [
        ("branch.1", "v1"),
        ("branch.2", "a"),
        ("branch.3", "v1"),
        ("next", "stop"),
    ]
    both = edited(program, "//(Wheel.Stop();, Door.Open(););")
    assert [(arc.out, arc.target) for arc in both.arcs if arc.source == "v1"] == [
        ("branch.1", "v1"),
        ("branch.2", "a"),
        ("branch.3", "v2"),
        ("next", "stop"),
    ]


def test_notes_stay_as_they_were_written_while_their_text_does() -> None:
    program = noted(
        graph("start > v1:While > v2:Wheel.Stop > stop", "v1.body > v1.return", "c:Run.IsTrue > v1.condition"),
        start=[Note("title")],
        v1=[Note("one"), Note("two\nthree"), Note("x", "after"), Note("end", "in:body")],
        c=[Note("of the test")],
        v2=[Note("behind", "after")],
        stop=[Note("a"), Note("b")],
    )
    text = print_program(graph_to_lll(program, shipped()).program)
    before = {vertex.id: vertex.notes for vertex in program.vertices}
    after = {vertex.id: vertex.notes for vertex in edited(program, text + "Door.Open();\n").vertices}
    for name in ("start", "v1", "c", "v2"):
        assert after[name] == before[name]
    changed = {vertex.id: vertex.notes for vertex in edited(program, text.replace("# two", "# 2")).vertices}
    assert changed["start"] == [Note("title")]
    assert changed["c"] == []
    assert changed["v1"][0] == Note("one\n2\nthree\nof the test")


def test_settings_that_say_the_same_stay_as_they_were_written() -> None:
    program = graph("start > v1:Repetition count=007 > v2:Wheel.Advance > stop", "v1.body > v1.return")
    program.vertices[-1].settings = {}
    after = edited(program, print_program(graph_to_lll(program, shipped()).program) + "Door.Open();")
    assert {vertex.id: vertex.settings for vertex in after.vertices}["v1"] == {"count": "007"}
    assert {vertex.id: vertex.settings for vertex in after.vertices}["v2"] == {}


def test_five_thousand_equal_instructions_and_an_edit_are_no_burden() -> None:
    seq = Seq([Wait(1) for _ in range(5000)])
    program = lll_to_graph(seq, ROBOT, shipped(), "p")
    changed = Seq([Call("Wheel", "Stop") if at == 2500 else Wait(1) for at in range(5001)])
    after = lll_to_graph(changed, ROBOT, shipped(), "p", program)
    assert elements(program).items() <= elements(after).items()
