"""`*( )`, a while without a condition: what it means, and what was written for it before."""

from __future__ import annotations

import pytest

from kitrobot.compiler.compilation import compile_text
from kitrobot.compiler.graph.graph_to_lll import graph_to_lll
from kitrobot.compiler.text.lll_to_graph import lll_to_graph
from kitrobot.compiler.text.text_edit import follow_text
from kitrobot.lll.formatter import format_text
from kitrobot.lll.parse_results import parse
from kitrobot.lll.printer import print_program
from kitrobot.lll.tree import Seq, While
from tests.compiler.graphs import graph, shipped

OLD = "*[Fault.IsRaised() | !(Fault.IsRaised())]"


def test_a_star_before_a_body_is_a_while_without_a_condition() -> None:
    assert parse("*();").program == Seq([While(None, Seq())])
    assert parse("Wheel.Stop() *() 2*()").program == parse("Wheel.Stop(); *(); 2*();").program


def test_it_is_formatted_as_other_loops_are() -> None:
    assert format_text("*(Wheel.Stop()\n;);*(\nWAIT(1);BREAK)")[0] == (
        "*( Wheel.Stop(); );\n*(\n  WAIT(1);\n  BREAK;\n);\n"
    )


@pytest.mark.parametrize(
    "body", ["", "WAIT(1);", "Wheel.Stop();", "[Run.IsTrue()](BREAK;);", f"{OLD}(WAIT(1);BREAK;);"]
)
def test_what_was_written_before_is_drawn_and_written_as_it_is_today(body: str) -> None:
    robot = shipped().robots["mini-robot"]
    text = f"# why\n{OLD}({body});  # and how\nWAIT(2);"
    drawn = lll_to_graph(parse(text).program, robot, shipped(), "p")
    assert drawn.vertices[1].element == "Forever"
    assert graph_to_lll(drawn, shipped()).program == parse(text.replace(OLD, "*")).program


def test_a_typed_text_of_before_is_followed_with_its_places() -> None:
    program = graph("start > v1:Wheel.Stop > stop")
    text = f"Wheel.Stop(); # here\n{OLD}(WAIT(1););\n"
    followed = follow_text(graph_to_lll(program, shipped()), text, shipped())
    assert followed.diagnostics == []
    assert followed.checked is not None
    assert followed.program is not None
    assert [vertex.element for vertex in followed.program.vertices if vertex.element == "Forever"]
    assert [text[span.start : span.end] for span in followed.spans][1] == f"{OLD}(WAIT(1);)"


def test_it_is_left_by_a_break_only() -> None:
    image = compile_text("*(WAIT(1););", shipped().robots["mini-robot"]).image
    assert image is not None
    assert len(image.code) == 4 * len(("WAIT", "JMP", "END"))


def test_a_loop_of_a_text_that_is_no_part_of_a_graph_prints_as_it_was_written() -> None:
    assert print_program(parse(f"{OLD}();").program) == f"{OLD}();\n"
