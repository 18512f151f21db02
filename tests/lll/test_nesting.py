"""Nesting is limited by `MAX_NESTING`, from both sides, and never by the host."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import pytest

from kitrobot.lll.formatter import format_text
from kitrobot.lll.parse_results import parse
from kitrobot.lll.printer import print_program
from kitrobot.lll.tree import MAX_NESTING
from tests.counting import MOST, growth
from tests.lll.frames import at_most_frames

DEEP: list[tuple[str, Callable[[int], str], int]] = [
    ("bodies of loops", lambda n: "1*(" * n + ")" * n, 0),
    ("bodies of whiles", lambda n: "*[a.b()](" * n + ")" * n, 0),
    ("bodies of conditionals", lambda n: "[a.b()](" * n + ")" * n, 0),
    ("else bodies", lambda n: "[a.b()]()!(" * n + ")" * n, 0),
    ("bodies of events", lambda n: "<a.b()>(" * n + ")" * n, 0),
    ("parallels", lambda n: "//(" * n + "a.b()" + ")" * n, 0),
    ("parentheses", lambda n: "[" + "(" * n + "a.b()" + ")" * n + "]()", 0),
    ("nots", lambda n: "[" + "!(" * n + "a.b()" + ")" * n + "]()", 0),
    ("an & chain", lambda n: "[a.b()" + "&a.b()" * n + "]()", 0),
    ("an | chain", lambda n: "[a.b()" + "|a.b()" * n + "]()", 0),
    ("& to the right", lambda n: "[" + "a.b()&(" * (n - 1) + "a.b()&a.b()" + ")" * (n - 1) + "]()", 0),
    ("parameters", lambda n: "a.b(" * n + "c.d()" + ")" * n, 0),
    ("parameters in a test", lambda n: "[" + "a.b(" * n + "c.d()" + ")" * n + "]()", 0),
    ("parameters beside parameters", lambda n: "a.b(c.d(e.f()), " * (n - 2) + "a.b(c.d(e.f()))" + ")" * (n - 2), 0),
    ("a chain in a body", lambda n: "1*(" * (n // 2) + "[a.b()" + "&a.b()" * (n - n // 2) + "]()" + ")" * (n // 2), 0),
    ("parameters in a chain", lambda n: "[a.b(c.d(e.f()))" + "&a.b()" * (n - 2) + "]()", 0),
    ("everything", lambda n: "//(2*([!(a.b())](" * (n // 3) + "c.d()" + ")))" * (n // 3), 1),
]


@pytest.mark.parametrize(("made", "spare"), [row[1:] for row in DEEP], ids=[row[0] for row in DEEP])
def test_a_program_at_the_limit_is_read_and_one_beyond_it_is_not(made: Callable[[int], str], spare: int) -> None:
    assert parse(made(MAX_NESTING - spare)).diagnostics == []
    beyond = parse(made(MAX_NESTING + 1 + 2 * spare))
    assert [item.code for item in beyond.diagnostics] == ["too-deep"]
    place = beyond.diagnostics[0].place
    assert place is not None
    assert place.end_column <= len(made(MAX_NESTING + 1 + 2 * spare)) + 1


@pytest.mark.parametrize("made", [row[1] for row in DEEP], ids=[row[0] for row in DEEP])
def test_a_program_at_the_limit_is_printed_and_read_again(made: Callable[[int], str]) -> None:
    with at_most_frames(850):
        program = parse(made(MAX_NESTING - MAX_NESTING % 3)).program
        again = parse(print_program(program))
    assert again.diagnostics == []
    assert again.program == program


@pytest.mark.parametrize("made", [row[1] for row in DEEP], ids=[row[0] for row in DEEP])
def test_ten_thousand_levels_are_refused_at_once(made: Callable[[int], str]) -> None:
    parsed = parse(made(10_000))
    assert [item.code for item in parsed.diagnostics if item.is_error] == ["too-deep"]
    assert growth(lambda n: partial(parse, made(n)), 1000) < MOST


@pytest.mark.parametrize("opener", ["[", "<", "(", "[(", "*[(", "[[", "<[", "°", "a.b(", "!(", "//(", "1*(", "{"])
def test_ten_thousand_openers_end_in_a_mistake(opener: str) -> None:
    with at_most_frames(850):
        parsed = parse(opener * 10_000)
    assert not parsed.ok
    assert len(parsed.diagnostics) < 4
    assert growth(lambda n: partial(parse, opener * n), 1000) < MOST


def test_what_follows_a_body_that_is_too_deep_is_read() -> None:
    deep = "1*(" * (MAX_NESTING + 5) + ")" * (MAX_NESTING + 5)
    parsed = parse(f"a.b();\n{deep};\nc.d(); 3;")
    assert [item.code for item in parsed.diagnostics] == ["too-deep", "syntax"]
    assert [getattr(node, "object", "") for node in parsed.program.items][-1] == "c"


def test_siblings_do_not_nest() -> None:
    assert parse("2*(a.b(c.d(e.f())););" * 5000).diagnostics == []


def test_conditions_of_different_instructions_do_not_add_up() -> None:
    chain = "[a.b()" + "&a.b()" * (MAX_NESTING - 1) + "](c.d(););"
    assert parse(chain * 3 + "1*(c.d());").diagnostics == []


def test_a_text_too_deep_is_not_formatted() -> None:
    text, diagnostics = format_text("1*(" * 200 + ")" * 200)
    assert text is None
    assert [item.code for item in diagnostics] == ["too-deep"]
