"""Vertices of a mission's own parts while the text beside them is edited: elsewhere, in their holes, in themselves."""

from __future__ import annotations

import random
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kitrobot.compiler.graph.graph_to_lll import graph_to_lll
from kitrobot.compiler.graph.own_part import Appearance, ChosenSlot, PartError, make_part, offer_part
from kitrobot.compiler.text.lll_to_graph import lll_to_graph
from kitrobot.graph.model import Arc, Note, Program, Vertex
from kitrobot.lll.parse_results import parse
from kitrobot.lll.printer import print_program
from kitrobot.primitives.catalogue import Catalogue
from kitrobot.primitives.constructors import Constructor, SlotKind
from tests.compiler.graphs import graph, noted, shipped, with_constructors
from tests.compiler.test_own_part import some_selection
from tests.strategies import Shape, random_program, shipped_robots


def with_own_parts(rng: random.Random) -> tuple[Program, Catalogue, list[Constructor]]:
    """A random program in which some stretches are parts of its own, one in the other too."""
    robot = rng.choice(list(shipped_robots().values()))
    seq = random_program(rng, robot, Shape(instructions=14, depth=4))
    program = lll_to_graph(parse(print_program(seq)).program, robot, shipped(), "p")
    own: list[Constructor] = []
    for number in range(rng.randint(1, 3)):
        catalogue = shipped().extended(own, [])
        vertices = some_selection(rng, program, catalogue)
        if vertices == ["start"]:
            break
        offers = offer_part(program, vertices, catalogue).offers
        chosen = [ChosenSlot(one.vertex, one.slot, one.name) for one in offers if rng.random() < 0.4]
        try:
            part = make_part(program, vertices, Appearance(f"Own {number}"), chosen, catalogue)
        except PartError:
            continue
        own.append(part.constructor)
        program = part.program
    return program, shipped().extended(own, []), own


def inserted(rng: random.Random, program: Program) -> Program:
    """The program with one more instruction, somewhere between two vertices or in an empty body."""
    flow = [at for at, arc in enumerate(program.arcs) if arc.at in ("in", "return")]
    at = rng.choice(flow)
    arc = program.arcs[at]
    new = Vertex("new", "Wait", {"duration": "54321"})
    arcs = [*program.arcs[:at], Arc(arc.source, "new", arc.out), Arc("new", arc.target, "next", arc.at)]
    return replace(program, vertices=[*program.vertices, new], arcs=arcs + program.arcs[at + 1 :])


def redrawn(program: Program, text: str, catalogue: Catalogue) -> Program:
    """The graph of an edited text beside the graph it came from; it says what the text says."""
    parsed = parse(text)
    assert parsed.ok, parsed.diagnostics
    drawn = lll_to_graph(parsed.program, catalogue.robots[program.target], catalogue, "p", program)
    assert graph_to_lll(drawn, catalogue).program == parse(text).program
    return drawn


def text_of(program: Program, catalogue: Catalogue) -> str:
    return print_program(graph_to_lll(program, catalogue).program)


def uses(program: Program) -> dict[str, str]:
    return {vertex.id: vertex.element for vertex in program.vertices if vertex.element.startswith("Own")}


@given(st.randoms(use_true_random=True))
def test_the_same_text_leaves_every_part(rng: random.Random) -> None:
    program, catalogue, _ = with_own_parts(rng)
    assert redrawn(program, text_of(program, catalogue), catalogue) == replace(program, name="p")


@given(st.randoms(use_true_random=True))
def test_a_new_instruction_outside_or_in_a_hole_leaves_every_part(rng: random.Random) -> None:
    program, catalogue, _ = with_own_parts(rng)
    edited = inserted(rng, program)
    after = redrawn(program, text_of(edited, catalogue), catalogue)
    assert uses(after) == uses(program)
    for vertex in program.vertices:
        now = next(one for one in after.vertices if one.id == vertex.id)
        assert (now.element, now.settings) == (vertex.element, vertex.settings)


@given(st.randoms(use_true_random=True))
def test_a_number_that_changes_in_a_hole_is_the_vertex_s_new_setting(rng: random.Random) -> None:
    program, catalogue, own = with_own_parts(rng)
    by_name = {one.name: one for one in own}
    numbers = [
        (vertex, slot)
        for vertex in program.vertices
        if vertex.element in by_name
        for slot in by_name[vertex.element].slots
        if slot.kind in (SlotKind.NUMBER, SlotKind.VALUE) and slot.name in vertex.settings
    ]
    if not numbers:
        return
    vertex, slot = rng.choice(numbers)
    value = str(rng.randint(slot.minimum or 0, slot.maximum if slot.maximum is not None else 99))
    if value == "0" or any(one.kind is SlotKind.FLOW for one in by_name[vertex.element].slots if value == "0"):
        return
    changed = replace(vertex, settings={**vertex.settings, slot.name: value})
    edited = replace(program, vertices=[changed if one is vertex else one for one in program.vertices])
    after = redrawn(program, text_of(edited, catalogue), catalogue)
    assert uses(after) == uses(program)
    assert next(one for one in after.vertices if one.id == vertex.id).settings == changed.settings


@given(st.randoms(use_true_random=True))
def test_any_other_text_is_still_what_is_drawn(rng: random.Random) -> None:
    program, catalogue, _ = with_own_parts(rng)
    lines = text_of(program, catalogue).splitlines()
    for _ in range(rng.randint(1, 3)):
        if lines and rng.random() < 0.5:
            lines.insert(rng.randrange(len(lines) + 1), rng.choice(["# why", "WAIT(7);", "2*( WAIT(1); );"]))
        elif lines:
            one = rng.randrange(len(lines))
            if parse("\n".join(lines[:one] + lines[one + 1 :])).ok:
                del lines[one]
    text = "\n".join(lines)
    if parse(text).ok:
        redrawn(program, text, catalogue)


AROUND = "Door.Open(); {body}; WAIT({n}); Door.Close();"
HEAD = '<constructor name="Own"><number name="n"/><flow name="body"/>'
PROGRAM = ["start > a:Light.LightOn > v1:Own n=3 > z:Light.LightOff > stop", "v1.body > w:Wheel.Stop > v1.return"]


@pytest.mark.parametrize(
    ("code", "before", "behind"),
    [
        ("Door.Open(); {body}; WAIT({n}); Door.Close();", "Door.Open();", "WAIT(3); Door.Close();"),
        ("{body}; WAIT({n});", "", "WAIT(3);"),
        ("WAIT({n}); {body};", "WAIT(3);", ""),
    ],
)
def test_a_body_among_the_part_s_own_instructions_keeps_the_vertex(code: str, before: str, behind: str) -> None:
    catalogue = with_constructors(f"{HEAD}<code>{code}</code></constructor>")
    program = noted(graph(*PROGRAM), v1=[Note("why"), Note("so", "after")], w=[Note("halt"), Note("now", "after")])
    text = text_of(program, catalogue)
    assert redrawn(program, text, catalogue) == program
    for edited in (
        "Motor.Stop();\n" + text,
        text + "Motor.Stop();\n",
        text.replace("Wheel.Stop();", "Wheel.Stop();\nMotor.Stop();\nWheel.Stop();"),
        text.replace("WAIT(3)", "WAIT(4)"),
        f"2*(\n{text});\n",
    ):
        after = redrawn(program, edited, catalogue)
        assert uses(after) == {"v1": "Own"}, edited
        assert next(one for one in after.vertices if one.id == "w").element == "Wheel.Stop"


@pytest.mark.parametrize("edited", ["Door.Close();", "Door.Open();", "WAIT(3);"])
def test_a_part_whose_own_instructions_go_dissolves(edited: str) -> None:
    catalogue = with_constructors(f"{HEAD}<code>{AROUND}</code></constructor>")
    program = graph(*PROGRAM)
    text = text_of(program, catalogue).replace(edited, "Motor.Stop();")
    assert uses(redrawn(program, text, catalogue)) == {}


def test_parts_in_the_bodies_of_parts_all_stay() -> None:
    catalogue = with_constructors(f"{HEAD}<code>{AROUND}</code></constructor>")
    program = graph(
        "start > v1:Own n=1 > stop",
        "v1.body > v2:Own n=2 > v3:Own n=3 > v1.return",
        "v2.body > v4:Own n=4 > v2.return",
        "v3.body > v3.return",
        "v4.body > v4.return",
    )
    text = text_of(program, catalogue)
    assert redrawn(program, text, catalogue) == program
    for edited in ("Wheel.Stop();\n" + text, text.replace("WAIT(3)", "WAIT(9)")):
        assert uses(redrawn(program, edited, catalogue)) == dict.fromkeys(("v1", "v2", "v3", "v4"), "Own")
