"""An edited text beside its graph: what did not change keeps its vertices, and the graph says what the text says."""

from __future__ import annotations

import random
import re
from collections.abc import Callable

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kitrobot.compiler.compilation import compile_program
from kitrobot.compiler.graph.graph_to_lll import graph_to_lll
from kitrobot.compiler.text.lll_to_graph import lll_to_graph
from kitrobot.compiler.text.preserve_ids import Old
from kitrobot.compiler.text.text_edit import follow_text
from kitrobot.graph.model import Note, Program
from kitrobot.lll.parse_results import parse
from kitrobot.lll.printer import print_program
from kitrobot.lll.tree import Seq
from kitrobot.primitives.catalogue import Catalogue
from tests.compiler.graphs import graph, noted, shipped
from tests.compiler.test_own_part_text import with_own_parts
from tests.effort import examples
from tests.strategies import Shape, random_program, shipped_robots


def text_of(program: Program, catalogue: Catalogue) -> str:
    return print_program(graph_to_lll(program, catalogue).program)


def edited(rng: random.Random, text: str) -> str:
    """The text with one to three small edits; it may have mistakes then."""
    lines = text.splitlines()
    for _ in range(rng.randint(1, 3)):
        at = rng.randrange(len(lines) + 1)
        kind = rng.randrange(5)
        if kind == 0 and at < len(lines):
            lines[at] = re.sub(r"\d+", str(rng.randrange(1, 250)), lines[at], count=1)
        elif kind == 1 and at < len(lines):
            del lines[at]
        elif kind == 2 and at < len(lines):
            lines.insert(at, lines[at])
        elif kind == 3 and at < len(lines):
            lines[at] += "  # so"
        else:
            lines.insert(at, rng.choice(["# why", "WAIT(7);", "2*( WAIT(1); );", "//( WAIT(1);, WAIT(2); );"]))
    return "\n".join(lines)


def in_order(program: Program) -> object:
    """A graph without the names of its vertices: they are numbered as they stand."""
    number = {vertex.id: at for at, vertex in enumerate(program.vertices)}
    vertices = [(vertex.element, vertex.settings, vertex.notes) for vertex in program.vertices]
    return vertices, [(number[arc.source], arc.out, number[arc.target], arc.at) for arc in program.arcs]


def some_program(rng: random.Random) -> Program:
    robot = rng.choice(list(shipped_robots().values()))
    seq = parse(print_program(random_program(rng, robot, Shape(comments=True)))).program
    return lll_to_graph(seq, robot, shipped(), "p")


def followed(program: Program, text: str, catalogue: Catalogue) -> Program | None:
    """The graph of a text, which says that very text; None when there are mistakes in it."""
    before = graph_to_lll(program, catalogue)
    found = follow_text(before, text, catalogue)
    assert graph_to_lll(program, catalogue).program == before.program
    if found.program is None:
        return None
    back = graph_to_lll(found.program, catalogue)
    assert found.translation is not None
    assert back.program == parse(text).program == found.translation.program
    assert found.translation.wiring.program == found.program
    ids = [vertex.id for vertex in found.program.vertices]
    assert len(ids) == len(set(ids))
    return found.program


@settings(max_examples=examples(12))
@given(st.randoms(use_true_random=True))
def test_what_is_taken_over_is_as_it_would_be_drawn(rng: random.Random) -> None:
    program = some_program(rng)
    robot = shipped().robot(program.target)
    for _ in range(3):
        text = edited(rng, text_of(program, shipped()))
        after = followed(program, text, shipped())
        if after is None:
            continue
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(Old, "unchanged", lambda *given: None)
            drawn = lll_to_graph(parse(text).program, robot, shipped(), "p", program)
        assert in_order(after) == in_order(drawn)
        program = after


@settings(max_examples=examples(12))
@given(st.randoms(use_true_random=True))
def test_what_was_checked_as_a_text_is_what_is_checked_as_a_graph(rng: random.Random) -> None:
    program = some_program(rng)
    for _ in range(3):
        text = edited(rng, text_of(program, shipped()))
        if parse(text).ok and rng.random() < 0.7:
            text = print_program(parse(text).program)
        found = follow_text(graph_to_lll(program, shipped()), text, shipped())
        if found.program is None or found.translation is None:
            continue
        program = found.program
        compiled = compile_program(program, shipped(), found.translation, found.checked)
        assert compiled == compile_program(program, shipped())
        if compiled.source.text == text:
            assert compiled.places == found.spans


@settings(max_examples=examples(12))
@given(st.randoms(use_true_random=True))
def test_beside_parts_of_one_s_own_any_edit_is_drawn(rng: random.Random) -> None:
    program, catalogue, _ = with_own_parts(rng)
    for _ in range(3):
        program = followed(program, edited(rng, text_of(program, catalogue)), catalogue) or program


PROGRAM = graph(
    "start > a:Light.LightOn > l:Repetition count=3 > z:Light.LightOff > stop",
    "l.body > b:Wait duration=2 > c:Wait duration=6 > p:Parallelism > l.return",
    "p.branch.1 > d:Wheel.Stop > p.return",
    "p.branch.2 > e:Wait duration=9 > p.return",
)


@pytest.mark.parametrize(
    ("edit", "ids"),
    [
        (lambda text: text.replace("WAIT(9)", "WAIT(95)"), "start a l b c p d e z stop"),
        (lambda text: text.replace("3*(", "31*("), "start a l b c p d e z stop"),
        (lambda text: text.replace("WAIT(2);", "WAIT(4);", 1), "start a l b c p d e z stop"),
        (lambda text: text.replace("WAIT(2);", "", 1), "start a l c p d e z stop"),
        (lambda text: text.replace("WAIT(9);", "WAIT(9); BREAK;"), "start a l b c p d e v1 z stop"),
        (lambda text: text.replace("WAIT(9);", "WAIT(1); WAIT(9);"), "start a l b c p d v1 e z stop"),
        (lambda text: "WAIT(1);\n" + text, "start v1 a l b c p d e z stop"),
        (lambda text: text + "WAIT(1);\n", "start a l b c p d e z v1 stop"),
        (lambda text: text.replace("Light.LightOff();", ""), "start a l b c p d e stop"),
        (lambda text: text.replace("Wheel.Stop();", "2*( Wheel.Stop(); );"), "start a l b c p v1 d e z stop"),
    ],
)
def test_what_stands_around_the_edit_keeps_its_vertices_and_its_order(edit: Callable[[str], str], ids: str) -> None:
    program = in_reading_order(PROGRAM)
    after = followed(program, edit(text_of(program, shipped())), shipped())
    assert after is not None
    assert [vertex.id for vertex in after.vertices] == ids.split()


def in_reading_order(program: Program) -> Program:
    """The same graph with its vertices and arcs as a text draws them."""
    robot = shipped().robot(program.target)
    longer = parse(text_of(program, shipped()) + "WAIT(65535);\n").program
    drawn = lll_to_graph(longer, robot, shipped(), program.name, program)
    return lll_to_graph(parse(text_of(program, shipped())).program, robot, shipped(), program.name, drawn)


def test_a_title_stays_with_start_and_one_that_goes_is_gone() -> None:
    program = noted(PROGRAM, start=[Note("The light")])
    text = text_of(program, shipped())
    after = followed(program, text.replace("Light.LightOn();", "Light.LightOff();"), shipped())
    assert after is not None
    assert after.vertices[0].notes == [Note("The light")]
    without = followed(program, text.replace("# The light\nLight.LightOn();", "WAIT(8);"), shipped())
    assert without is not None
    assert without.vertices[0].notes == []


def test_what_hangs_loose_stays_beside_an_edit() -> None:
    program = graph("start > a:Light.LightOn > b:Wait duration=2 > stop", "x:Light.LightOff > y:Wait duration=5")
    after = followed(program, "Light.LightOn(); WAIT(25);", shipped())
    assert after is not None
    assert {vertex.id for vertex in after.vertices} == {"start", "a", "b", "stop", "x", "y"}
    assert [arc for arc in after.arcs if arc.source == "x"] == [arc for arc in program.arcs if arc.source == "x"]


def test_an_arc_from_what_hangs_loose_into_the_edited_instruction_is_not_lost() -> None:
    program = graph("start > a:Light.LightOn > b:Wait duration=2 > stop", "x:Light.LightOff > b")
    after = followed(program, "Light.LightOn(); WAIT(25);", shipped())
    assert after is not None
    assert ("x", "b") in [(arc.source, arc.target) for arc in after.arcs]


def test_an_empty_program_is_typed_into() -> None:
    program = graph("start > stop")
    assert graph_to_lll(program, shipped()).program == Seq()
    after = followed(program, "WAIT(1);", shipped())
    assert after is not None
    assert [vertex.element for vertex in after.vertices] == ["Start", "Wait", "Stop"]
