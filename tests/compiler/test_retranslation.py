"""A state of a program made from the one before: all that is said of it is what is said of it alone."""

from __future__ import annotations

import random
from dataclasses import replace
from typing import Any

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from kitrobot.compiler import retranslation as retranslating
from kitrobot.compiler.compilation import Compiled, compile_program
from kitrobot.compiler.graph_to_lll import Translation, graph_to_lll
from kitrobot.compiler.lll_to_graph import lll_to_graph
from kitrobot.compiler.retranslation import graph_to_lll_again
from kitrobot.compiler.text_edit import _follow_near, _follow_whole
from kitrobot.compiler.vertex_places import vertex_places
from kitrobot.graph.model import IN, NEXT, RETURN, Arc, Note, Program, Vertex
from kitrobot.lll.parse_results import parse
from kitrobot.lll.printer import print_program
from kitrobot.lll.walk import nodes
from kitrobot.primitives.catalogue import Catalogue
from kitrobot.workspace.compile_cache import CompileCache
from tests.compiler.graphs import graph, noted, shipped
from tests.compiler.test_own_part_text import with_own_parts
from tests.compiler.test_stretch import edited, in_order, text_of
from tests.effort import examples
from tests.strategies import Shape, random_program, shipped_robots


def placed(compiled: Compiled) -> list[Any]:
    """The nodes of the tree with what does not count when trees are compared."""
    return [(type(node), node.vertex, node.start, node.end) for node in nodes(compiled.program)]


def says_the_same(made: Translation, program: Program, catalogue: Catalogue) -> None:
    """Holds a translation, and what is compiled of it, against those of the program alone."""
    alone = graph_to_lll(program, catalogue)
    assert made.program == alone.program
    assert made.diagnostics == alone.diagnostics
    assert (made.stretches, made.pieces) == (alone.stretches, alone.pieces)
    for what in ("vertices", "out", "fills", "start", "stop"):
        assert getattr(made.wiring, what) == getattr(alone.wiring, what), what
    # In the order of the arcs, which says nothing.
    ports, expected_ports = ({one: sorted(of) for one, of in each.wiring.ports.items()} for each in (made, alone))
    assert ports == expected_ports
    assert made.wiring.program is program
    compiled, expected = compile_program(program, catalogue, made), compile_program(program, catalogue, alone)
    assert compiled == expected
    assert placed(compiled) == placed(expected)
    places = vertex_places(made.program, compiled.source, made.lineage)
    assert places == vertex_places(alone.program, expected.source)


def with_edit(rng: random.Random, program: Program, number: int) -> Program:
    """The program with one change of its graph, good or bad; it shares what stayed."""
    vertices, arcs = list(program.vertices), list(program.arcs)
    at = rng.randrange(len(vertices))
    one, arc = vertices[at], rng.choice(arcs)
    kind = rng.randrange(12)
    if kind == 0:
        vertices[at] = replace(one, settings={name: str(rng.randrange(9)) for name in one.settings})
    elif kind == 1:
        vertices[at] = replace(one, notes=[Note("why"), Note("so", "after")][: rng.randrange(3)])
    elif kind in (2, 3, 4):
        new = Vertex(f"x{number}", *rng.choice([("Wait", {"duration": "4"}), ("Repetition", {"count": "2"})]))
        vertices.insert(at, new)
        place = arcs.index(arc)
        inside = [Arc(new.id, new.id, "body", RETURN)] if new.element == "Repetition" else []
        arcs[place : place + 1] = [Arc(arc.source, new.id, arc.out, IN), *inside, Arc(new.id, arc.target, NEXT, arc.at)]
    elif kind in (5, 6):
        into = [each for each in arcs if each.target == one.id and each.at == IN]
        on = [each for each in arcs if each.source == one.id and each.out == NEXT]
        if len(into) == len(on) == 1:
            del vertices[at]
            arcs = [each for each in arcs if one.id not in (each.source, each.target)]
            arcs.append(Arc(into[0].source, on[0].target, into[0].out, on[0].at))
    elif kind == 7:
        vertices[at] = replace(one, element=rng.choice(vertices).element)
    elif kind == 8:
        arcs[arcs.index(arc)] = replace(arc, target=rng.choice(vertices).id)
    elif kind in (9, 10):
        return with_loop_around(rng, program, f"x{number}")
    else:
        rng.shuffle(vertices)
        arcs.remove(arc)
        arcs.insert(rng.randrange(len(arcs) + 1), arc)
    return replace(program, vertices=vertices, arcs=arcs)


def with_loop_around(rng: random.Random, program: Program, name: str) -> Program:
    """The program with a loop around some of its vertices that follow one another, which so stand deeper."""
    on = {arc.source: arc for arc in program.arcs if arc.out == NEXT}
    into = {arc.target: arc for arc in program.arcs if arc.at == IN}
    first = rng.choice([arc.target for arc in program.arcs if arc.at == IN])
    last = first
    for _ in range(rng.randrange(6)):
        if last not in on or on[last].at != IN or on[last].target not in into:
            break
        last = on[last].target
    if last not in on or first not in into:
        return program
    entry, leaving = into[first], on[last]
    arcs = [arc for arc in program.arcs if arc is not entry and arc is not leaving]
    arcs += [
        Arc(entry.source, name, entry.out, IN),
        Arc(name, first, "body", IN),
        Arc(last, name, NEXT, RETURN),
        Arc(name, leaving.target, NEXT, leaving.at),
    ]
    return replace(program, vertices=[*program.vertices, Vertex(name, "Repetition", {"count": "2"})], arcs=arcs)


def drawn(rng: random.Random) -> Program:
    robot = rng.choice(list(shipped_robots().values()))
    seq = parse(print_program(random_program(rng, robot, Shape(comments=True)))).program
    return lll_to_graph(seq, robot, shipped(), "p")


@settings(max_examples=examples(60), deadline=None)
@example(random.Random(62))  # lines move though characters do not
@given(st.randoms(use_true_random=True))
def test_a_state_says_what_it_would_say_alone(rng: random.Random) -> None:
    states = [graph_to_lll(drawn(rng), shipped())]
    for number in range(12):
        # Now and then an edit is taken back, or two windows edit the same program.
        before = states[-1] if rng.random() < 0.8 else rng.choice(states)
        program = with_edit(rng, before.wiring.program, number)
        made = graph_to_lll_again(before, program, shipped())
        says_the_same(made, program, shipped())
        states.append(made)


@settings(max_examples=examples(30), deadline=None)
@example(random.Random(3665))  # a part of one's own that begins with its hole has a note
@given(st.randoms(use_true_random=True))
def test_so_it_is_beside_parts_of_one_s_own(rng: random.Random) -> None:
    program, catalogue, _ = with_own_parts(rng)
    made = graph_to_lll(program, catalogue)
    for number in range(6):
        program = with_edit(rng, made.wiring.program, number)
        made = graph_to_lll_again(made, program, catalogue)
        says_the_same(made, program, catalogue)


@settings(max_examples=examples(60), deadline=None)
@given(st.randoms(use_true_random=True))
def test_a_text_of_which_some_lines_changed_is_followed_as_the_whole(rng: random.Random) -> None:
    made = graph_to_lll(drawn(rng), shipped())
    for _ in range(8):
        text = edited(rng, print_program(graph_to_lll(made.wiring.program, shipped()).program))
        parsed = parse(text)
        if parsed.ok and rng.random() < 0.7:
            text = print_program(parsed.program)
        whole = _follow_whole(graph_to_lll(made.wiring.program, shipped()), text, shipped())
        with made.lineage.lock:
            near = _follow_near(made, text, shipped())
        if near is None:
            continue
        assert whole.program is not None
        assert near.program is not None
        assert near.translation is not None
        assert in_order(near.program) == in_order(whole.program)
        assert near.diagnostics == whole.diagnostics
        number = {vertex.id: at for at, vertex in enumerate(near.program.vertices)}
        other = {vertex.id: at for at, vertex in enumerate(whole.program.vertices)}
        assert [(number[one.vertex], *one[1:]) for one in near.spans] == [
            (other[one.vertex], *one[1:]) for one in whole.spans
        ]
        made = near.translation
        says_the_same(made, near.program, shipped())


LONG = graph(
    "start > a:Light.LightOn > l:Repetition count=3 > z:Light.LightOff > w:Wait duration=3 > stop",
    "l.body > b:Wait duration=2 > m:Repetition count=2 > l.return",
    "m.body > c:Wait duration=6 > d:Wait duration=7 > m.return",
)


@pytest.fixture
def never_whole(monkeypatch: pytest.MonkeyPatch) -> None:
    def never(*given: object) -> Translation:
        raise AssertionError("the whole was translated")

    monkeypatch.setattr(retranslating, "graph_to_lll", never)


@pytest.mark.usefixtures("never_whole")
def test_what_an_edit_does_not_touch_is_taken_over() -> None:
    before = graph_to_lll(LONG, shipped())
    vertices = [replace(one, settings={"duration": "60"}) if one.id == "c" else one for one in LONG.vertices]
    made = graph_to_lll_again(before, replace(LONG, vertices=vertices), shipped())
    for name in ("a", "b", "d", "z", "w"):
        assert made.pieces[name].row[0] is before.pieces[name].row[0]
    for name in ("l", "m", "c"):
        assert made.pieces[name].row[0] is not before.pieces[name].row[0]


@pytest.mark.usefixtures("never_whole")
def test_a_title_stands_above_what_is_first_alone() -> None:
    program = noted(LONG, start=[Note("The light")])
    before = graph_to_lll(program, shipped())
    arcs = [arc for arc in program.arcs if arc.source != "start"]
    new = Vertex("n", "Wait", {"duration": "1"})
    after = replace(program, vertices=[*program.vertices, new], arcs=[Arc("start", "n"), Arc("n", "a"), *arcs])
    made = graph_to_lll_again(before, after, shipped())
    assert print_program(made.program).startswith("# The light\nWAIT(1);\nLight.LightOn();\n")


def test_a_key_reads_the_lines_around_it_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    before = graph_to_lll(LONG, shipped())
    text = text_of(LONG, shipped())
    first = _follow_near(before, text.replace("WAIT(6)", "WAIT(65)"), shipped())
    assert first is not None
    assert first.translation is not None
    read: list[str] = []

    def noting(text: str, *more: object) -> Any:
        read.append(text)
        return parse(text)

    monkeypatch.setattr("kitrobot.compiler.near_edit.parse", noting)
    second = _follow_near(first.translation, text.replace("WAIT(6)", "WAIT(654)"), shipped())
    assert second is not None
    assert read == ["    WAIT(654);\n"]


@pytest.mark.parametrize(
    "edit",
    [
        lambda text: text.replace("WAIT(6);", "WAIT( 6);"),
        lambda text: text.replace("WAIT(6);", "WAIT(6); WAIT(1);"),
        lambda text: text.replace("WAIT(6);", "WAIT(6"),
        lambda text: text.replace("WAIT(6);", "Light.Lighton();"),
        lambda text: text.replace("    WAIT(6);\n", ""),
        lambda text: text + "# at the end\n",
        lambda text: "",
        lambda text: text,
    ],
)
def test_what_is_not_printed_so_or_not_understood_is_looked_at_whole(edit: Any) -> None:
    text = edit(text_of(LONG, shipped()))
    assert _follow_near(graph_to_lll(LONG, shipped()), text, shipped()) is None


def test_an_earlier_state_still_tells_where_its_instructions_stand() -> None:
    kept = CompileCache()
    first = kept.of(LONG, shipped()).compiled
    new = Vertex("n", "Wait", {"duration": "12345"})
    arcs = [Arc("start", "n"), Arc("n", "a"), *(arc for arc in LONG.arcs if arc.source != "start")]
    second = kept.of(replace(LONG, vertices=[*LONG.vertices, new], arcs=arcs), shipped()).compiled
    shared = {id(node) for node in nodes(first.program)} & {id(node) for node in nodes(second.program)}
    assert shared
    for state in (first, second):
        own = {node.vertex: state.source.text[node.start : node.end] for node in state.placed.items}
        assert own["z"] == "Light.LightOff()"
        assert own["w"] == "WAIT(3)"
