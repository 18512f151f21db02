"""A selection becomes a constructor, and a vertex of it takes the selection's place."""

from __future__ import annotations

import random
from copy import deepcopy
from dataclasses import replace

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from kitrobot.compiler.compilation import compile_program
from kitrobot.compiler.graph.graph_to_lll import graph_to_lll
from kitrobot.compiler.graph.own_part import Appearance, ChosenSlot, Part, PartError, make_part, offer_part
from kitrobot.compiler.graph.part_offers import Offer
from kitrobot.compiler.graph.selection import SelectionError, chain_behind
from kitrobot.compiler.text.lll_to_graph import lll_to_graph
from kitrobot.graph.model import NEXT, Note, Program
from kitrobot.lll.parse_results import parse
from kitrobot.lll.printer import print_program
from kitrobot.lll.tree import Seq
from kitrobot.lll.walk import nodes
from kitrobot.primitives.catalogue import Catalogue
from kitrobot.primitives.constructors import Role
from tests.compiler.graphs import graph, noted, shipped, text_of
from tests.strategies import Shape, random_program, shipped_robots

LOOK = Appearance("My part")


def drawn(text: str) -> Program:
    """The graph of a text; its vertices are v1, v2, … in reading order."""
    parsed = parse(text)
    assert parsed.ok, parsed.diagnostics
    return lll_to_graph(parsed.program, shipped().robot("mini-robot"), shipped(), "p")


def made(program: Program, vertices: list[str], *chosen: ChosenSlot) -> Part:
    return make_part(program, vertices, LOOK, chosen, shipped())


def offers(program: Program, *vertices: str) -> dict[str, Offer]:
    return {one.name: one for one in offer_part(program, vertices, shipped()).offers}


def with_part(part: Part) -> Catalogue:
    return shipped().extended([part.constructor], [])


def some_selection(rng: random.Random, program: Program, catalogue: Catalogue | None = None) -> list[str]:
    """Some vertices in a row of one of the program's chains."""
    wiring = graph_to_lll(program, catalogue or shipped()).wiring
    chains = [chain_behind(wiring, vertex, port) for vertex, port in wiring.out if port != NEXT or vertex == "start"]
    chains = [[one for one in chain if one != "stop"] for chain in chains]
    chain = rng.choice([chain for chain in chains if chain] or [["start"]])
    first = rng.randrange(len(chain))
    return chain[first : rng.randint(first, min(len(chain), first + 6)) + 1]


@example(random.Random(9044))  # a test with a number that its sensor never reads
@example(random.Random(919))  # a test inside a parameter of something that is left open
@given(st.randoms(use_true_random=True))
def test_a_program_means_the_same_with_a_part_in_the_selection_s_place(rng: random.Random) -> None:
    robot = rng.choice(list(shipped_robots().values()))
    seq = random_program(rng, robot, Shape(instructions=12, depth=4, comments=rng.random() < 0.3))
    program = lll_to_graph(seq, robot, shipped(), "p")
    vertices = some_selection(rng, program)
    rng.shuffle(vertices)
    try:
        offered = offer_part(program, vertices, shipped())
    except SelectionError:
        if vertices != ["start"]:
            raise
        return
    chosen = [
        ChosenSlot(one.vertex, one.slot, rng.choice([one.name, one.name, "Größe", "speed of it"]))
        for one in offered.offers
        if rng.random() < 0.4
    ]
    try:
        part = make_part(program, vertices, LOOK, chosen, shipped())
    except PartError as error:
        refusals = ("two places", "leaves a loop", "only a hole", "different things", "stands there twice", "empty")
        if not any(word in error.message for word in (*refusals, "characters")):
            raise
        return
    before = graph_to_lll(program, shipped())
    after = graph_to_lll(part.program, with_part(part))
    assert [item for item in after.diagnostics if item.is_error] == [
        item for item in before.diagnostics if item.is_error
    ]
    assert _without_notes(after.program) == _without_notes(before.program)
    if before.ok:
        one, other = compile_program(program, shipped()), compile_program(part.program, with_part(part))
        assert one.image is not None
        assert other.image is not None
        assert one.image.to_bytes() == other.image.to_bytes()
    for note in (note for vertex in program.vertices for note in vertex.notes):
        assert any(note.text in other.text for vertex in part.program.vertices for other in vertex.notes)


def _without_notes(seq: Seq) -> str:
    bare = deepcopy(seq)
    for node in nodes(bare):
        for name in ("above", "below"):
            getattr(node, name, []).clear()
        if hasattr(node, "after"):
            node.after = None
    return print_program(bare)


def test_a_stretch_offers_its_numbers_bodies_conditions_and_actions() -> None:
    program = drawn("Wheel.Advance(50); *[Run.IsTrue()]( WAIT(3); Wheel.Advance(60); ); Wheel.Stop();")
    found = offer_part(program, ["v2", "v1"], shipped())
    assert found.role is Role.INSTRUCTION
    assert [(one.vertex, one.slot, str(one.kind), one.name, one.value, one.inside) for one in found.offers] == [
        ("v1", "", "flow", "action", "", None),
        ("v1", "speed", "value", "speed", "50", ("v1", "")),
        ("v2", "condition", "condition", "condition", "", None),
        ("v2", "body", "flow", "body", "", None),
        ("v4", "duration", "number", "duration", "3", ("v2", "body")),
        ("v5", "", "flow", "action2", "", ("v2", "body")),
        ("v5", "speed", "value", "speed2", "60", ("v5", "")),
    ]


def test_what_is_chosen_becomes_slots_of_the_template() -> None:
    program = drawn("Wheel.Advance(50); *[Run.IsTrue()]( WAIT(3); ); Wheel.Advance(50); Wheel.Stop();")
    part = made(
        program,
        ["v1", "v5"],
        ChosenSlot("v1", "speed", "Speed", 10, 90),
        ChosenSlot("v5", "speed", "Speed", 10, 90),
        ChosenSlot("v2", "condition", "as long as"),
        ChosenSlot("v2", "body", "body"),
    )
    assert part.constructor.code == ("Wheel.Advance({Speed}); *[{as_long_as}]({body}); Wheel.Advance({Speed});")
    speed, condition, body = part.constructor.slots
    assert (speed.kind, speed.minimum, speed.maximum, speed.default) == ("number", 10, 90, "50")
    assert (condition.label, body.label) == ({"": "as long as"}, {})
    vertex = next(one for one in part.program.vertices if one.id == part.vertex)
    assert (vertex.element, vertex.settings) == ("My part", {"Speed": "50"})
    assert text_of(part.program, with_part(part)) == text_of(program)


def test_a_condition_becomes_a_condition() -> None:
    program = drawn("*[Run.IsTrue() & !(Captor.EqualTo(4))]( Wheel.Stop(); );")
    joined = next(one.id for one in program.vertices if one.element == "And")
    less = next(one.id for one in program.vertices if one.element.endswith("EqualTo"))
    limit = next(one for one in offers(program, joined).values() if one.vertex == less)
    part = made(program, [joined], ChosenSlot(less, limit.slot, "limit"))
    assert part.constructor.role is Role.CONDITION
    assert part.constructor.code == "Run.IsTrue() & !(Captor.EqualTo({limit}))"
    assert text_of(part.program, with_part(part)) == text_of(program)


def test_a_branch_s_bodies_become_branches_of_the_part() -> None:
    program = drawn("//( Wheel.Stop();, WAIT(3); );")
    branch = next(one for one in offers(program, "v1").values() if one.kind == "flow" and one.vertex == "v1")
    part = made(program, ["v1"], ChosenSlot("v1", branch.slot, "sides"))
    assert (part.constructor.code, part.constructor.slots[0].least) == ("//( {sides}; );", 2)
    assert text_of(part.program, with_part(part)) == text_of(program)


def test_notes_of_what_goes_are_notes_of_the_part() -> None:
    program = noted(
        graph("start > v1:Wheel.Stop > v2:Wheel.Stop > stop"),
        v1=[Note("first")],
        v2=[Note("second"), Note("end", "after")],
    )
    part = made(program, ["v1", "v2"])
    assert text_of(part.program, with_part(part)) == "# first\n# second\nWheel.Stop();\nWheel.Stop();  # end\n"


@pytest.mark.parametrize(
    ("text", "vertices", "words"),
    [
        ("Wheel.Stop();", [], "nothing is selected"),
        ("Wheel.Stop();", ["start", "stop"], "nothing is selected"),
        ("Wheel.Stop();", ["v9"], "no vertex `v9`"),
        ("*[Run.IsTrue()]( Wheel.Stop(); );", ["v2"], "`Run.IsTrue` alone cannot be a part"),
        ("*[Run.IsTrue()]( Wheel.Stop(); ); WAIT(2);", ["v2", "v4"], "conditions or values beside other parts"),
        ("*[Run.IsTrue()]( Wheel.Stop(); ); *[Run.IsTrue()]( WAIT(1); );", ["v3", "v6"], "several chains"),
    ],
)
def test_what_is_no_selection_is_told(text: str, vertices: list[str], words: str) -> None:
    with pytest.raises(SelectionError, match=words.replace("(", r"\(")):
        offer_part(drawn(text), vertices, shipped())


@pytest.mark.parametrize(
    ("text", "vertices", "chosen", "words"),
    [
        ("*[Run.IsTrue()]( BREAK; );", ["v3"], [], "a Break in the selection leaves a loop"),
        ("Wheel.Stop();", ["v1"], [ChosenSlot("v1", "", "all")], "only a hole"),
        ("Wheel.Stop();", ["v1"], [ChosenSlot("v1", "speed", "s")], "nothing named `speed`"),
        ("Wheel.Advance(50);", ["v1"], [ChosenSlot("v1", "speed", "s", 60, 10)], "min at most max"),
        ("Wheel.Advance(50);", ["v1"], [ChosenSlot("v1", "speed", "s", 10, 60, "x")], "default"),
        (
            "Wheel.Advance(5); Wheel.Advance(6);",
            ["v1", "v2"],
            [ChosenSlot("v1", "speed", "s"), ChosenSlot("v2", "speed", "s")],
            "`s` stands for different things: 5, 6",
        ),
        (
            "Wheel.Stop(); WAIT(1); Wheel.Stop();",
            ["v1", "v2", "v3"],
            [ChosenSlot("v1", "", "a"), ChosenSlot("v3", "", "b")],
            "two places",
        ),
    ],
)
def test_what_makes_no_template_is_told(text: str, vertices: list[str], chosen: list[ChosenSlot], words: str) -> None:
    with pytest.raises(PartError) as caught:
        made(drawn(text), vertices, *chosen)
    assert words in caught.value.message


def test_an_open_slot_has_to_be_left_open() -> None:
    program = graph("start > v1:While > stop", "v1.body > v2:Wheel.Stop > v1.return")
    assert offers(program, "v1")["condition"].is_open
    assert made(program, ["v1"]).constructor.code == "*[{condition}]( Wheel.Stop(); );"


def test_what_nobody_knows_is_told_unless_it_is_left_out() -> None:
    program = graph("start > v1:While > stop", "v1.body > v2:Odd.Thing > v1.return")
    assert [item.vertices for item in offer_part(program, ["v1"], shipped()).diagnostics] == [("v2",)]
    with pytest.raises(PartError, match="not in the robot"):
        made(program, ["v1"])
    assert made(program, ["v1"], ChosenSlot("v1", "body", "body")).constructor.code == "*[{condition}]({body});"


@pytest.mark.parametrize("name", ["While", "", " x", "Start", "a.b"])
def test_a_name_that_cannot_be_is_told(name: str) -> None:
    with pytest.raises(PartError):
        make_part(drawn("Wheel.Stop();"), ["v1"], replace(LOOK, name=name), (), shipped())


def test_a_selection_that_is_too_long_is_told() -> None:
    program = drawn("Wheel.Advance(50);" * 700)
    with pytest.raises(PartError, match="at most 10000 characters"):
        made(program, [f"v{number}" for number in range(1, 701)])
