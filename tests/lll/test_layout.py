"""The one true layout, as people read it."""

from __future__ import annotations

import random

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kitrobot.lll.formatter import format_text
from kitrobot.lll.parse_results import parse
from kitrobot.lll.printer import print_program
from kitrobot.lll.tree import And, Call, Conditional, Not, Or, Seq
from tests.strategies import Shape, random_program, random_robot, shipped_robots

CARRIER = """\
*[Run.IsTrue()](
  //(
    <Sign.EqualTo(0)>( Lamp.LightOn(); );,
    °Wheel.Advance(50)°;
    *[Run.IsTrue()](
      <Collision.IsPressed()>(
        Wheel.Stop();
        <Collision.IsReleased()>( °Wheel.Advance(50)°; );
      );
    );
  );
  <Cargo.IsPressed()>( Lamp.LightOff(); );
);
"""


def laid_out(text: str) -> str:
    made, diagnostics = format_text(text)
    assert made is not None, diagnostics
    return made


def test_the_carrier_of_the_studio_s_picture_is_laid_out_as_in_the_picture() -> None:
    assert laid_out("".join(CARRIER.split())) == CARRIER
    assert laid_out(CARRIER) == CARRIER


LAYOUTS = [
    ("nothing", "", ""),
    ("separators", " ;; ; ", ""),
    ("a call", "a.b( )", "a.b();\n"),
    ("numbers", "a.b( 1 ,02 )", "a.b(1, 2);\n"),
    ("calls in calls", "a . b(c.d( e.f(1)),2)", "a.b(c.d(e.f(1)), 2);\n"),
    ("two calls", "a.b()c.d()", "a.b();\nc.d();\n"),
    ("a mark", "\u02da a.b() \u00ba", "°a.b()°;\n"),
    ("a wait", "WAIT( 10 )", "WAIT(10);\n"),
    ("a break", "BREAK", "BREAK;\n"),
    ("a body of one instruction", "3*(a.b())", "3*( a.b(); );\n"),
    ("a body of two instructions", "3*(a.b();c.d())", "3*(\n  a.b();\n  c.d();\n);\n"),
    ("an empty body", "3 * ( )", "3*();\n"),
    ("an empty while", "*[a.b()]()", "*[a.b()]();\n"),
    ("an empty event", "<a.b()>()", "<a.b()>();\n"),
    ("a body that is a loop", "3*(2*(a.b()))", "3*(\n  2*( a.b(); );\n);\n"),
    ("an interrupt in a body", "3*(°a.b()°)", "3*( °a.b()°; );\n"),
    ("a condition", "[a.b()&c.d()|!(e.f())](g.h())", "[a.b() & c.d() | !(e.f())]( g.h(); );\n"),
    ("two short sides", "[a.b()](c.d())!(e.f())", "[a.b()]( c.d(); )!( e.f(); );\n"),
    ("an empty first side", "[a.b()]()!(e.f())", "[a.b()]()!( e.f(); );\n"),
    ("two empty sides", "[a.b()]()!()", "[a.b()]()!();\n"),
    (
        "one long side",
        "[a.b()](c.d())!(e.f();g.h())",
        "[a.b()](\n  c.d();\n)!(\n  e.f();\n  g.h();\n);\n",
    ),
    ("a parallel", "//(a.b(),c.d())", "//(\n  a.b();,\n  c.d();\n);\n"),
    ("a parallel of nothing", "//(,,)", "//();\n"),
    ("a branch of two", "//(a.b();c.d(),e.f())", "//(\n  a.b();\n  c.d();,\n  e.f();\n);\n"),
    ("comments", "#x\na.b()#y\n#z", "# x\na.b();  # y\n# z\n"),
    ("an empty comment", "#\na.b()", "#\na.b();\n"),
    ("a comment keeps a body off the line", "3*(a.b()#x\n)", "3*(\n  a.b();  # x\n);\n"),
    ("a comment in an empty body", "3*(#x\n)", "3*(\n  # x\n);\n"),
    ("a comment behind a branch", "//(a.b()#x\n,c.d())", "//(\n  a.b();,  # x\n  c.d();\n);\n"),
    ("blank lines go", "a.b();\n\n\n\nc.d();", "a.b();\nc.d();\n"),
]


@pytest.mark.parametrize(("text", "layout"), [row[1:] for row in LAYOUTS], ids=[row[0] for row in LAYOUTS])
def test_a_program_has_one_layout(text: str, layout: str) -> None:
    assert laid_out(text) == layout
    assert laid_out(layout) == layout


@pytest.mark.parametrize(
    ("name", "line"),
    [(26, "[{0}.isPressedOrSo()]( {0}.b(); );"), (22, "[a.b()]( {0}.a(); )!( {0}.b(); );"), (52, "1*( {0}.b(); );")],
    ids=["a body", "two sides", "a loop"],
)
def test_a_body_stays_on_its_line_up_to_sixty_characters(name: int, line: str) -> None:
    widest = next(n for n in range(60, 0, -1) if len(line.format("x" * n)) <= 60)
    fits = line.format("x" * widest) + "\n"
    assert len(fits) - 1 in (59, 60)
    assert laid_out(fits) == fits
    assert laid_out(line.format("x" * (widest + 1))).count("\n") > 1


def test_the_level_of_a_body_counts_in_the_width_of_its_line() -> None:
    line = "1*( " + "x" * 48 + ".b(); );"
    assert len(line) == 60
    assert laid_out(line).count("\n") == 1
    assert laid_out(f"2*({line}a.b())").count("\n") == 6


x, y, z = Call("a", "x"), Call("a", "y"), Call("a", "z")

PARENTHESES = [
    (And(And(x, y), z), "a.x() & a.y() & a.z()"),
    (And(x, And(y, z)), "a.x() & (a.y() & a.z())"),
    (Or(Or(x, y), z), "a.x() | a.y() | a.z()"),
    (Or(x, Or(y, z)), "a.x() | (a.y() | a.z())"),
    (Or(And(x, y), z), "a.x() & a.y() | a.z()"),
    (Or(x, And(y, z)), "a.x() | a.y() & a.z()"),
    (And(Or(x, y), z), "(a.x() | a.y()) & a.z()"),
    (And(x, Or(y, z)), "a.x() & (a.y() | a.z())"),
    (Not(And(x, y)), "!(a.x() & a.y())"),
    (Not(Not(x)), "!(!(a.x()))"),
    (And(Not(x), Not(y)), "!(a.x()) & !(a.y())"),
]


@pytest.mark.parametrize(("tree", "text"), PARENTHESES, ids=[row[1] for row in PARENTHESES])
def test_parentheses_stand_where_the_tree_needs_them(tree: And | Or | Not, text: str) -> None:
    program = Seq([Conditional(tree, Seq())])
    assert print_program(program) == f"[{text}]();\n"
    assert parse(print_program(program)).program == program


def test_a_text_with_a_mistake_is_not_laid_out() -> None:
    text, diagnostics = format_text("a.b(;", "mine.lll")
    assert text is None
    assert [item.place.file for item in diagnostics if item.place] == ["mine.lll"]


def test_a_text_with_hints_only_is_laid_out_and_the_hints_are_told() -> None:
    text, diagnostics = format_text("a.b() c.d()")
    assert text == "a.b();\nc.d();\n"
    assert [item.code for item in diagnostics] == ["missing-semicolon"]


def random_text(rng: random.Random) -> str:
    robot = rng.choice([*shipped_robots().values(), random_robot(rng)])
    return print_program(random_program(rng, robot, Shape(instructions=30, comments=True)))


@given(st.randoms(use_true_random=True))
def test_reading_what_was_printed_gives_the_program_and_printing_it_again_the_text(rng: random.Random) -> None:
    text = random_text(rng)
    parsed = parse(text)
    assert parsed.diagnostics == []
    printed = print_program(parsed.program)
    assert printed == text
    assert parse(printed).program == parsed.program


@given(st.randoms(use_true_random=True))
def test_a_printed_program_reads_the_same_without_its_layout(rng: random.Random) -> None:
    robot = rng.choice([*shipped_robots().values()])
    text = print_program(random_program(rng, robot, Shape(instructions=30)))
    assert parse("".join(text.split())).program == parse(text).program


@given(st.randoms(use_true_random=True))
def test_a_printed_line_has_no_blank_at_its_end_and_no_tab(rng: random.Random) -> None:
    for line in random_text(rng).split("\n"):
        assert line == line.rstrip()
        assert "\t" not in line
