"""What each constructor and each arrangement of arcs becomes in LLL."""

from __future__ import annotations

import pytest

from kitrobot.graph.model import Note
from kitrobot.lll.printer import print_program
from kitrobot.lll.tree import Call
from kitrobot.lll.walk import nodes
from tests.compiler.graphs import graph, noted, shipped, text_of, translated

GRAPHS = [
    ("the smallest", ["start > stop"], ""),
    ("an action", ["start > v1:Wheel.Stop > stop"], "Wheel.Stop();"),
    ("two actions", ["start > v1:Wheel.Stop > v2:Door.Open > stop"], "Wheel.Stop(); Door.Open();"),
    ("a setting", ["start > v1:Wheel.Advance speed=7 > stop"], "Wheel.Advance(7);"),
    ("a setting left out", ["start > v1:Wheel.Advance > stop"], "Wheel.Advance(50);"),
    ("two settings", ["start > v1:Motor.AbsoluteTurn speed=1 angle=2 > stop"], "Motor.AbsoluteTurn(2, 1);"),
    (
        "a value in a parameter",
        ["start > v1:Wheel.Advance > stop", "v2:Captor.Value > v1.speed"],
        "Wheel.Advance(Captor.Value());",
    ),
    (
        "a value wins over a setting",
        ["start > v1:Wheel.Advance speed=7 > stop", "v2:Captor.Value > v1.speed"],
        "Wheel.Advance(Captor.Value());",
    ),
    (
        "Repetition",
        ["start > v1:Repetition count=3 > stop", "v1.body > v2:Wheel.Stop > v1.return"],
        "3*( Wheel.Stop(); );",
    ),
    ("an empty body", ["start > v1:Repetition > stop", "v1.body > v1.return"], "10*();"),
    (
        "While",
        ["start > v1:While > stop", "v2:Run.IsTrue > v1.condition", "v1.body > v3:Wheel.Stop > v1.return"],
        "*[Run.IsTrue()]( Wheel.Stop(); );",
    ),
    (
        "If Then",
        ["start > v1:If_Then > stop", "v2:Run.IsTrue > v1.condition", "v1.then > v3:Wheel.Stop > v1.return"],
        "[Run.IsTrue()]( Wheel.Stop(); );",
    ),
    (
        "If Then Else",
        [
            "start > v1:If_Then_Else > stop",
            "v2:Run.IsTrue > v1.condition",
            "v1.then > v1.return",
            "v1.else > v3:Wheel.Stop > v1.return",
        ],
        "[Run.IsTrue()]()!( Wheel.Stop(); );",
    ),
    (
        "When",
        ["start > v1:When > stop", "v2:Run.IsTrue > v1.condition", "v1.body > v3:Wheel.Stop > v1.return"],
        "<Run.IsTrue()>( Wheel.Stop(); );",
    ),
    ("Wait", ["start > v1:Wait time=7 > stop"], "WAIT(7);"),
    ("Break", ["start > v1:Break > stop"], "BREAK;"),
    (
        "And, Or, No",
        [
            "start > v1:When > stop",
            "v1.body > v1.return",
            "v3:And > v1.condition",
            "v2:Run.IsTrue > v3.left",
            "v6:Or > v3.right",
            "v5:No > v6.left",
            "v4:Flag.IsTrue > v5.condition",
            "v7:Button.IsPressed > v6.right",
        ],
        "<Run.IsTrue() & (!(Flag.IsTrue()) | Button.IsPressed())>();",
    ),
    (
        "Parallelism",
        [
            "start > v1:Parallelism > stop",
            "v1.branch.1 > v2:Wheel.Stop > v1.return",
            "v1.branch.2 > v3:Door.Open > v4:Door.Close > v1.return",
        ],
        "//( Wheel.Stop();, Door.Open(); Door.Close(); );",
    ),
    (
        "branches in the order of their numbers",
        [
            "start > v1:Parallelism > stop",
            "v1.branch.10 > v2:Wheel.Stop > v1.return",
            "v1.branch.2 > v3:Door.Open > v1.return",
            "v1.branch.7 > v1.return",
        ],
        "//( Door.Open();, Wheel.Stop(); );",
    ),
    ("a Parallelism of no branch", ["start > v1:Parallelism > stop"], "//();"),
    (
        "Interrupt",
        ["start > v1:Interrupt > stop", "v2:Wheel.Advance speed=5 > v1.action"],
        "°Wheel.Advance(5)°;",
    ),
    ("Forever", ["start > v1:Forever > stop", "v1.body > v2:Wait time=1 > v1.return"], "*( WAIT(1); );"),
    (
        "Repeat Until",
        ["start > v1:Repeat_Until > stop", "v2:Run.IsTrue > v1.condition", "v1.body > v1.return"],
        "*[!(Run.IsTrue())]();",
    ),
    ("Wait Until", ["start > v1:Wait_Until > stop", "v2:Run.IsTrue > v1.condition"], "<Run.IsTrue()>();"),
    (
        "Unless",
        ["start > v1:Unless > stop", "v2:Run.IsTrue > v1.condition", "v1.then > v3:Wheel.Stop > v1.return"],
        "[!(Run.IsTrue())]( Wheel.Stop(); );",
    ),
    (
        "a body in a body",
        [
            "start > v1:Repetition count=2 > stop",
            "v1.body > v2:Repetition count=3 > v3:Wheel.Stop > v1.return",
            "v2.body > v4:Door.Open > v2.return",
        ],
        "2*( 3*( Door.Open(); ); Wheel.Stop(); );",
    ),
]


@pytest.mark.parametrize(("lines", "text"), [row[1:] for row in GRAPHS], ids=[row[0] for row in GRAPHS])
def test_a_graph_becomes_lll(lines: list[str], text: str) -> None:
    slots = {slot.name for slot in shipped().constructors["Wait"].slots}
    lines = [line.replace("time=", f"{slots.pop()}=") if "time=" in line else line for line in lines]
    assert " ".join(text_of(graph(*lines)).split()) == text


def test_every_vertex_leaves_its_id_on_what_it_became() -> None:
    program = graph(
        "start > v1:Repeat_Until > v2:Wheel.Advance > stop",
        "v3:No > v1.condition",
        "v4:Run.IsTrue > v3.condition",
        "v1.body > v5:Interrupt > v1.return",
        "v6:Wheel.Stop > v5.action",
        "v7:Captor.Value > v2.speed",
    )
    tree = translated(program).program
    assert {node.vertex for node in nodes(tree)} - {None} == {f"v{n}" for n in range(1, 8)}
    text = print_program(tree)
    places = {node.vertex: text[node.start : node.end] for node in nodes(tree) if isinstance(node, Call)}
    assert places["v4"] == "Run.IsTrue()"
    assert places["v6"] == "Wheel.Stop()"
    assert places["v7"] == "Captor.Value()"


def test_notes_become_comments_at_their_places() -> None:
    program = noted(
        graph(
            "start > v1:While > v2:Parallelism > stop",
            "v3:Run.IsTrue > v1.condition",
            "v1.body > v4:Wheel.Stop > v1.return",
            "v2.branch.1 > v5:Door.Open > v2.return",
            "v2.branch.2 > v6:Door.Close > v2.return",
        ),
        start=[Note("the beginning")],
        v1=[Note("two\nlines"), Note("in the head", "after"), Note("end of body", "in:body")],
        v3=[Note("about the test")],
        v4=[Note("slowly", "after")],
        v2=[Note("end of branch", "in:branch.2")],
        v6=[Note("closing")],
        stop=[Note("the end")],
    )
    text = """\
# the beginning
# two
# lines
# about the test
*[Run.IsTrue()](
  Wheel.Stop();  # slowly
  # end of body
);  # in the head
//(
  Door.Open();,
  # closing
  Door.Close();
  # end of branch
);
# the end
"""
    assert text_of(program) == text


def test_the_note_of_a_start_before_nothing_is_kept() -> None:
    assert text_of(noted(graph("start > stop"), start=[Note("a")], stop=[Note("b")])) == "# a\n# b\n"


def test_lines_of_a_note_behind_an_instruction_become_one() -> None:
    program = noted(graph("start > v1:Break > stop"), v1=[Note("a\nb", "after"), Note("c", "after")])
    assert text_of(program) == "BREAK;  # a b c\n"


def test_the_note_of_an_empty_branch_goes_above_its_parallel() -> None:
    program = noted(
        graph("start > v1:Parallelism > stop", "v1.branch.1 > v1.return", "v1.branch.2 > v2:Break > v1.return"),
        v1=[Note("nothing yet", "in:branch.1")],
    )
    assert text_of(program) == "# nothing yet\n//(\n  BREAK;\n);\n"
