"""Each line of the grammar: what is read, and what tree it becomes."""

from __future__ import annotations

import pytest

from kitrobot.diagnostics.model import Fix
from kitrobot.lll.parse_results import parse
from kitrobot.lll.tree import (
    And,
    Break,
    Call,
    Conditional,
    Event,
    Instr,
    Interrupt,
    Not,
    Number,
    Or,
    Parallel,
    Repeat,
    Seq,
    Wait,
    While,
)


def c(name: str, *params: object) -> Call:
    """`a.b` or `a.b(…)` as a tree."""
    made, method = name.split(".")
    return Call(made, method, [Number(param) if isinstance(param, int) else param for param in params])  # type: ignore[misc]


GRAMMAR: list[tuple[str, str, list[Instr]]] = [
    ("an empty program", "", []),
    ("a program of separators", ";;;", []),
    ("a call", "a.b();", [c("a.b")]),
    ("a call with a number", "a.b(5);", [c("a.b", 5)]),
    ("a call with numbers", "a.b(1, 22,333);", [c("a.b", 1, 22, 333)]),
    ("a call with a call", "a.b(c.d());", [c("a.b", c("c.d"))]),
    ("a call with calls in calls and numbers", "a.b(c.d(e.f(1)), 2);", [c("a.b", c("c.d", c("e.f", 1)), 2)]),
    ("white space in a call", "a . b ( 1 , 2 ) ;", [c("a.b", 1, 2)]),
    ("two instructions", "a.b(); c.d();", [c("a.b"), c("c.d")]),
    ("no `;` after the last", "a.b(); c.d()", [c("a.b"), c("c.d")]),
    ("an interrupt", "°a.b(1)°;", [Interrupt(c("a.b", 1))]),
    ("a repeat", "3*(a.b(););", [Repeat(3, Seq([c("a.b")]))]),
    ("a repeat of nothing", "3*();", [Repeat(3, Seq())]),
    ("white space in a repeat", "3 * ( a.b(); ) ;", [Repeat(3, Seq([c("a.b")]))]),
    ("a while", "*[a.b()](c.d(););", [While(c("a.b"), Seq([c("c.d")]))]),
    ("a while of nothing", "*[a.b()]();", [While(c("a.b"), Seq())]),
    ("a conditional", "[a.b()](c.d(););", [Conditional(c("a.b"), Seq([c("c.d")]))]),
    (
        "a conditional with two sides",
        "[a.b()](c.d();)!(e.f(););",
        [Conditional(c("a.b"), Seq([c("c.d")]), Seq([c("e.f")]))],
    ),
    ("a conditional with an empty side", "[a.b()](c.d();)!();", [Conditional(c("a.b"), Seq([c("c.d")]), Seq())]),
    ("an event", "<a.b()>(c.d(););", [Event(c("a.b"), Seq([c("c.d")]))]),
    ("an event of nothing", "<a.b()>();", [Event(c("a.b"), Seq())]),
    ("a parallel", "//(a.b();, c.d(););", [Parallel([Seq([c("a.b")]), Seq([c("c.d")])])]),
    ("a parallel of one branch", "//(a.b(););", [Parallel([Seq([c("a.b")])])]),
    ("a parallel of no branch", "//();", [Parallel([])]),
    ("a missing branch in the middle", "//(a.b();,,c.d(););", [Parallel([Seq([c("a.b")]), Seq([c("c.d")])])]),
    ("a missing branch at the end", "//(a.b();,);", [Parallel([Seq([c("a.b")])])]),
    ("branches of separators only", "//(;,a.b();,;;);", [Parallel([Seq([c("a.b")])])]),
    ("branches without `;`", "//(a.b(),c.d());", [Parallel([Seq([c("a.b")]), Seq([c("c.d")])])]),
    ("a wait", "WAIT(10);", [Wait(10)]),
    ("white space in a wait", "WAIT ( 10 ) ;", [Wait(10)]),
    ("a break", "BREAK;", [Break()]),
    ("a body in a body", "2*(3*(a.b();););", [Repeat(2, Seq([Repeat(3, Seq([c("a.b")]))]))]),
    ("instructions over lines", "a\n.\nb\n(\n1\n)\n;", [c("a.b", 1)]),
]


@pytest.mark.parametrize(("text", "items"), [row[1:] for row in GRAMMAR], ids=[row[0] for row in GRAMMAR])
def test_an_instruction_is_read(text: str, items: list[Instr]) -> None:
    parsed = parse(text)
    assert parsed.diagnostics == []
    assert parsed.program == Seq(items)


CONDITIONS = [
    ("a test", "a.b()", c("a.b")),
    ("and", "a.b() & c.d()", And(c("a.b"), c("c.d"))),
    ("or", "a.b() | c.d()", Or(c("a.b"), c("c.d"))),
    ("not", "!(a.b())", Not(c("a.b"))),
    ("and binds tighter, on the left", "a.b() & c.d() | e.f()", Or(And(c("a.b"), c("c.d")), c("e.f"))),
    ("and binds tighter, on the right", "a.b() | c.d() & e.f()", Or(c("a.b"), And(c("c.d"), c("e.f")))),
    ("and goes left to right", "a.b() & c.d() & e.f()", And(And(c("a.b"), c("c.d")), c("e.f"))),
    ("or goes left to right", "a.b() | c.d() | e.f()", Or(Or(c("a.b"), c("c.d")), c("e.f"))),
    ("parentheses", "a.b() & (c.d() | e.f())", And(c("a.b"), Or(c("c.d"), c("e.f")))),
    ("parentheses that change nothing", "((a.b()))", c("a.b")),
    ("not of a joined test", "!(a.b() | c.d()) & e.f()", And(Not(Or(c("a.b"), c("c.d"))), c("e.f"))),
    ("a test with parameters", "a.b(1, c.d())", c("a.b", 1, c("c.d"))),
]


@pytest.mark.parametrize("around", ["*[{}]();", "[{}]();", "<{}>();"], ids=["while", "conditional", "event"])
@pytest.mark.parametrize(("text", "tree"), [row[1:] for row in CONDITIONS], ids=[row[0] for row in CONDITIONS])
def test_a_condition_is_read(text: str, tree: object, around: str) -> None:
    parsed = parse(around.format(text))
    assert parsed.diagnostics == []
    node = parsed.program.items[0]
    assert isinstance(node, While | Conditional | Event)
    assert node.condition == tree


@pytest.mark.parametrize("mark", ["\u00b0", "\u00ba", "\u02da"], ids=["degree", "ordinal", "ring above"])
def test_every_sign_that_looks_like_the_mark_is_read_as_the_mark(mark: str) -> None:
    parsed = parse(f"{mark}a.b(){mark}; {mark} c.d(){mark};")
    assert parsed.diagnostics == []
    assert parsed.program == Seq([Interrupt(c("a.b")), Interrupt(c("c.d"))])


def test_marks_of_two_kinds_may_be_partners() -> None:
    assert parse("\u00b0a.b()\u02da;").program == Seq([Interrupt(c("a.b"))])


@pytest.mark.parametrize(
    "second",
    ["c.d()", "3*()", "*[a.b()]()", "[a.b()]()", "<a.b()>()", "//()", "°c.d()°", "WAIT(1)", "BREAK"],
)
def test_a_missing_separator_is_a_hint_that_mends_it(second: str) -> None:
    text = f"a.b() {second};"
    parsed = parse(text)
    (hint,) = parsed.diagnostics
    assert parsed.ok
    assert (hint.code, hint.fix) == ("missing-semicolon", Fix(";"))
    assert hint.place is not None
    assert (hint.place.column, hint.place.end_column) == (6, 6)
    assert hint.fix is not None
    mended = text[:5] + hint.fix.text + text[5:]
    assert parse(mended).diagnostics == []
    assert parse(mended).program == parsed.program


@pytest.mark.parametrize("text", ["a.b()", "a.b();", "2*(a.b())", "//(a.b(), c.d())", "a.b()  # why\n", "a.b()\n;"])
def test_a_separator_that_separates_nothing_may_be_left_out(text: str) -> None:
    assert parse(text).diagnostics == []
