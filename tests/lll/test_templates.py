"""Templates of constructors: LLL with holes."""

from __future__ import annotations

import pytest

from kitrobot.lll.parse_results import parse, parse_template
from kitrobot.lll.printer import print_program
from kitrobot.lll.tree import And, Break, Call, Hole, Interrupt, Not, Number, Parallel, Repeat, Seq, Wait, While

TEMPLATES = [
    ("{n}*({body})", Repeat(Hole("n"), Seq(hole=Hole("body")))),
    ("*[{c}]({body})", While(Hole("c"), Seq(hole=Hole("body")))),
    ("*[{c}]({body};)", While(Hole("c"), Seq(hole=Hole("body")))),
    ("WAIT({n})", Wait(Hole("n"))),
    ("°{action}°", Interrupt(Hole("action"))),
    ("//({branch})", Parallel([Seq(hole=Hole("branch"))])),
    ("//({a}, {b})", Parallel([Seq(hole=Hole("a")), Seq(hole=Hole("b"))])),
    ("{left} & {right}", And(Hole("left"), Hole("right"))),
    ("!({c})", Not(Hole("c"))),
    ("a.b({x}, 2)", Call("a", "b", [Hole("x"), Number(2)])),
    ("BREAK", Break()),
    ("a.b(); WAIT({n})", Seq([Call("a", "b"), Wait(Hole("n"))])),
    ("*[{c}]({body}; WAIT(1))", While(Hole("c"), Seq([Wait(1)], hole=Hole("body")))),
    ("*[{c}](WAIT(1); {body})", While(Hole("c"), Seq([Wait(1)], hole=Hole("body"), hole_at=1))),
    (
        "*[{c}](WAIT(1); {body}; WAIT(2))",
        While(Hole("c"), Seq([Wait(1), Wait(2)], hole=Hole("body"), hole_at=1)),
    ),
    ("{body}; WAIT(1)", Seq([Wait(1)], hole=Hole("body"))),
    ("a.b(); {body}", Seq([Call("a", "b")], hole=Hole("body"), hole_at=1)),
    ("{ n }*( { body } )", Repeat(Hole("n"), Seq(hole=Hole("body")))),
]


@pytest.mark.parametrize(("text", "tree"), TEMPLATES, ids=[row[0] for row in TEMPLATES])
def test_a_template_is_read(text: str, tree: object) -> None:
    assert parse_template(text) == (tree, [])


@pytest.mark.parametrize("text", [row[0] for row in TEMPLATES if isinstance(row[1], Seq | While | Repeat)])
def test_a_template_that_is_printed_reads_the_same(text: str) -> None:
    tree, _ = parse_template(text)
    printed = print_program(tree if isinstance(tree, Seq) else Seq([tree]))  # type: ignore[list-item]
    assert parse_template(printed)[0] == tree


def test_a_template_that_is_one_hole_is_that_hole() -> None:
    assert parse_template("{a}")[0] == Hole("a")
    assert parse_template("{a};")[0] == Hole("a")


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "a template cannot be empty"),
        (" \n ", "a template cannot be empty"),
        ("{a}; {b}", "one hole stands in a body, and `{a}` stands in this one already"),
        ("2*({a}; WAIT(1); {b})", "one hole stands in a body, and `{a}` stands in this one already"),
        ("{a} & ", "expected a condition, found the end of the text"),
        ("*[{c}]({body}", "this `(` is never closed"),
        ("{1a}*()", "expected an instruction, found `{`"),
    ],
)
def test_a_template_that_is_not_lll_says_why(text: str, message: str) -> None:
    tree, diagnostics = parse_template(text)
    assert tree is None
    assert [item.message for item in diagnostics] == [message]


def test_a_program_has_no_holes() -> None:
    for text, _ in TEMPLATES:
        codes = {item.code for item in parse(f"{text};").diagnostics}
        assert ("hole-in-program" in codes or "&" in text or "!" in text) == ("{" in text)
