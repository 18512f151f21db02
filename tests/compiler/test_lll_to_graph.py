"""LLL → graph: templates run backwards; with graph → LLL it is the identity."""

from __future__ import annotations

import random

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kitrobot.compiler.graph.graph_to_lll import graph_to_lll
from kitrobot.compiler.text.lll_to_graph import lll_to_graph
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.graph.model import Arc, Note, Program, Vertex
from kitrobot.lll.parse_results import parse
from kitrobot.lll.printer import print_program
from kitrobot.lll.tree import MAX_NESTING, Seq
from kitrobot.primitives.catalogue import Catalogue
from tests.compiler.graphs import shipped, with_constructors
from tests.strategies import Shape, random_program, random_robot, shipped_robots


def drawn(text: str, catalogue: Catalogue | None = None) -> Program:
    parsed = parse(text)
    assert parsed.diagnostics == []
    return lll_to_graph(parsed.program, shipped().robots["mini-robot"], catalogue or shipped(), "p")


def written(program: Program, catalogue: Catalogue | None = None) -> str:
    translation = graph_to_lll(program, catalogue or shipped())
    assert translation.diagnostics == []
    return print_program(translation.program)


def test_a_program_becomes_vertices_and_arcs() -> None:
    program = drawn("*[Run.IsTrue()](Wheel.Advance(7); 2*(););  Motor.AbsoluteTurn(Captor.Value(), 3);")
    assert program.vertices == [
        Vertex("start", "Start"),
        Vertex("v1", "While"),
        Vertex("v2", "Run.IsTrue"),
        Vertex("v3", "Wheel.Advance", {"speed": "7"}),
        Vertex("v4", "Repetition", {"count": "2"}),
        Vertex("v5", "Motor.AbsoluteTurn", {"speed": "3"}),
        Vertex("v6", "Captor.Value"),
        Vertex("stop", "Stop"),
    ]
    assert program.arcs == [
        Arc("start", "v1"),
        Arc("v2", "v1", at="condition"),
        Arc("v1", "v3", out="body"),
        Arc("v3", "v4"),
        Arc("v4", "v4", out="body", at="return"),
        Arc("v4", "v1", at="return"),
        Arc("v1", "v5"),
        Arc("v6", "v5", at="angle"),
        Arc("v5", "stop"),
    ]


def test_an_empty_program_is_start_and_stop() -> None:
    assert drawn("") == Program(
        "p", "mini-robot", [Vertex("start", "Start"), Vertex("stop", "Stop")], [Arc("start", "stop")]
    )


ELEMENTS = [
    ("Wheel.Stop();", "Wheel.Stop"),
    ("2*();", "Repetition"),
    ("*[Run.IsTrue()]();", "While"),
    ("[Run.IsTrue()]();", "If Then"),
    ("[Run.IsTrue()]()!();", "If Then Else"),
    ("*();", "Forever"),
    ("*[!(Run.IsTrue())]();", "Repeat Until"),
    ("[!(Run.IsTrue())]();", "Unless"),
    ("[!(Run.IsTrue())]()!();", "If Then Else"),
    ("<Run.IsTrue()>();", "Wait Until"),
    ("<Run.IsTrue()>(Wheel.Stop(););", "When"),
    ("<Run.IsTrue()>(\n  # nothing\n);", "When"),
    ("//(Wheel.Stop(););", "Parallelism"),
    ("//();", "Parallelism"),
    ("°Wheel.Stop()°;", "Interrupt"),
    ("WAIT(1);", "Wait"),
    ("BREAK;", "Break"),
    ("<Run.IsTrue() & Flag.IsTrue()>();", "And"),
    ("<Run.IsTrue() | Flag.IsTrue()>();", "Or"),
    ("<!(Run.IsTrue())>();", "No"),
]


@pytest.mark.parametrize(("text", "element"), ELEMENTS)
def test_each_construct_has_its_constructor(text: str, element: str) -> None:
    program = drawn(text)
    assert element in [vertex.element for vertex in program.vertices]
    assert parse(written(program)).program == parse(text).program


def test_branches_are_numbered_from_one() -> None:
    program = drawn("//(Wheel.Stop();, Door.Open();, Door.Close(););")
    assert [arc.out for arc in program.arcs if arc.source == "v1"] == ["branch.1", "branch.2", "branch.3", "next"]


NOTED = """\
# above
# and more
*[Run.IsTrue()](  # first in the body
  Wheel.Stop();  # behind
  # end of the body
);  # behind the loop
[Run.IsTrue()](
  # empty then
)!(
  Door.Open();
  # end of else
);
//(
  # in a branch
  Wheel.Stop();
  # end of branch 1
  ,
  Door.Close();,  # behind the branch
  Light.LightOn();
  # end of branch 3
);
# the end
#
"""


def test_a_comment_of_every_kind_is_a_note_at_its_place() -> None:
    notes = {(vertex.element, note.at): note.text for vertex in drawn(NOTED).vertices for note in vertex.notes}
    assert notes[("While", "")] == "above\nand more"
    assert notes[("While", "after")] == "behind the loop"
    assert notes[("While", "in:body")] == "end of the body"
    assert notes[("If Then Else", "in:then")] == "empty then"
    assert notes[("If Then Else", "in:else")] == "end of else"
    assert notes[("Parallelism", "in:branch.1")] == "end of branch 1"
    assert notes[("Parallelism", "in:branch.3")] == "end of branch 3"
    assert notes[("Door.Close", "after")] == "behind the branch"
    assert notes[("Stop", "")] == "the end\n"


def test_comments_of_every_kind_come_back_to_their_places() -> None:
    assert parse(written(drawn(NOTED))).program == parse(NOTED).program


def test_a_text_that_nests_to_the_limit_comes_back() -> None:
    texts = [
        "1*(" * MAX_NESTING + ")" * MAX_NESTING,
        "1*(" * (MAX_NESTING - 1) + "[Run.IsTrue() & Flag.IsTrue()](Wheel.Stop();)" + ")" * (MAX_NESTING - 1),
        "[" + "Run.IsTrue() | " * MAX_NESTING + "Run.IsTrue()]()",
        "[" + "!(" * MAX_NESTING + "Run.IsTrue()" + ")" * MAX_NESTING + "]()",
        "[Captor.LessThan(Captor.Value())" + "& Run.IsTrue()" * (MAX_NESTING - 1) + "]()",
    ]
    for text in texts:
        assert parse(written(drawn(text))).program == parse(text).program


def test_a_call_the_robot_does_not_know_is_kept() -> None:
    program = lll_to_graph(parse("Gripper.Grab(5, 7);").program, shipped().robots["mini-robot"], shipped(), "p")
    assert program.vertices[1] == Vertex("v1", "Gripper.Grab", {"parameter1": "5", "parameter2": "7"})
    translation = graph_to_lll(program, shipped())
    assert print_program(translation.program) == "Gripper.Grab(5, 7);\n"


def test_a_constructor_of_one_s_own_that_is_one_construct_takes_the_place_of_none_that_was_there_first() -> None:
    own = '<constructor name="Loop"><condition name="c"/><flow name="b"/><code>*[{c}]({b})</code></constructor>'
    catalogue = with_constructors(own)
    assert [vertex.element for vertex in drawn("*[Run.IsTrue()]();", catalogue).vertices][1] == "While"


def test_a_catalogue_without_the_inverse_of_a_construct_says_so() -> None:
    catalogue = Catalogue(shipped().robots, [])
    assert drawn("Wheel.Stop();", catalogue).vertices[1].element == "Wheel.Stop"
    with pytest.raises(KitRobotError, match="no constructor at hand draws the LLL construct Wait"):
        drawn("WAIT(1);", catalogue)


@given(st.randoms(use_true_random=True))
def test_text_to_graph_to_text_is_the_identity(rng: random.Random) -> None:
    robot = rng.choice([*shipped_robots().values(), random_robot(rng)])
    catalogue = Catalogue({**shipped().robots, robot.name: robot}, shipped().groups)
    program = parse(print_program(random_program(rng, robot, Shape(comments=True)))).program
    back = graph_to_lll(lll_to_graph(program, robot, catalogue, "p"), catalogue)
    assert back.diagnostics == []
    assert back.program == program


@given(st.randoms(use_true_random=True))
def test_graph_to_text_to_graph_is_the_identity(rng: random.Random) -> None:
    robot = rng.choice([*shipped_robots().values()])
    program = parse(print_program(random_program(rng, robot, Shape(comments=True)))).program
    graph = lll_to_graph(program, robot, shipped(), "p")
    text = print_program(graph_to_lll(graph, shipped()).program)
    assert lll_to_graph(parse(text).program, robot, shipped(), "p") == graph


def test_notes_of_a_graph_come_back_as_they_were() -> None:
    program = Program(
        "p",
        "mini-robot",
        [
            Vertex("start", "Start"),
            Vertex("v1", "Repetition", {"count": "2"}, [Note("a\nb"), Note("c", "after"), Note("d\n e", "in:body")]),
            Vertex("v2", "Wheel.Stop", {}, [Note(" f"), Note("# g", "after")]),
            Vertex("stop", "Stop", {}, [Note("h\n\ni")]),
        ],
        [Arc("start", "v1"), Arc("v1", "v2", "body"), Arc("v2", "v1", at="return"), Arc("v1", "stop")],
    )
    text = written(program)
    again = drawn(text)
    assert [vertex.notes for vertex in again.vertices] == [vertex.notes for vertex in program.vertices]


def test_an_empty_sequence_draws_nothing_between_start_and_stop() -> None:
    program = lll_to_graph(Seq(), shipped().robots["mini-robot"], shipped(), "p")
    assert program.arcs == [Arc("start", "stop")]
