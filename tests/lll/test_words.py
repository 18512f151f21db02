"""Names, numbers and white space."""

from __future__ import annotations

import pytest

from kitrobot.lll.parse_results import parse
from kitrobot.lll.tokens import is_name
from kitrobot.lll.tree import Call, Number, Repeat, Seq, Wait
from kitrobot.text.forms import name_form

NAMES = [
    "a",
    "_",
    "__1",
    "Wheel2",
    "Größe",
    "ÉTAGE",
    "étage",  # accents as letters of their own
    "e\u0301tage",  # and as marks upon letters
    "پہیہ",
    "مقام۲",
    "नमस्ते",
    "गाड़ी१",
    "ไฟ",
    "ก็",
    "휠",
    "车轮",
    "колесо",
    "Ａ",
    "𝒳",
    "WAITING",
    "Break",
]
NO_NAMES = [
    "",
    " ",
    "1",
    "1a",
    "a b",
    "a.b",
    "a#",
    " a",
    "a ",
    "a\n",
    "٣x",
    "१क",
    "²x",
    "Ⅷ",
    "①",
    "\u0301a",
    "ºb",
    "°",
    "§",
    "a-b",
    "{a}",
    "a;",
    "WAIT",
    "BREAK",
]


@pytest.mark.parametrize("name", NAMES)
def test_letters_of_any_script_make_a_name(name: str) -> None:
    assert is_name(name)
    parsed = parse(f"{name}.{name}({name}.{name}());{name}.{name}(7);")
    assert parsed.diagnostics == []
    one = name_form(name)  # whatever form it was typed in
    assert parsed.program == Seq([Call(one, one, [Call(one, one)]), Call(one, one, [Number(7)])])


@pytest.mark.parametrize("text", NO_NAMES)
def test_what_is_no_name_is_no_name(text: str) -> None:
    assert not is_name(text)


@pytest.mark.parametrize("word", ["WAIT", "BREAK"])
@pytest.mark.parametrize("call", ["{}.x();", "x.{}();", "x.{}(a.b());", "a.b({}.c());"])
def test_a_reserved_word_is_no_name_in_a_call(word: str, call: str) -> None:
    (mistake,) = parse(call.format(word)).diagnostics
    assert mistake.code == "reserved-word"
    assert f"`{word}`" in mistake.message


def test_case_matters_in_names() -> None:
    assert parse("a.b();").program != parse("A.b();").program


@pytest.mark.parametrize(
    ("digits", "value"), [("0", 0), ("65535", 65535), ("007", 7), ("00000000000000065535", 65535), ("0" * 5000, 0)]
)
def test_a_number_in_range_is_read(digits: str, value: int) -> None:
    parsed = parse(f"a.b({digits}, {digits}); {digits}*(); WAIT({digits});")
    assert parsed.diagnostics == []
    assert parsed.program == Seq([Call("a", "b", [Number(value), Number(value)]), Repeat(value, Seq()), Wait(value)])


@pytest.mark.parametrize("digits", ["65536", "065536", "99999", "100000", "9" * 5000])
@pytest.mark.parametrize(
    ("text", "column"), [("a.b({});", 5), ("a.b(1, {});", 8), ("a.b({}, c.d());", 5), ("{}*();", 1), ("WAIT({});", 6)]
)
def test_a_number_beyond_the_largest_is_an_error_at_the_number(digits: str, text: str, column: int) -> None:
    parsed = parse(text.format(digits))
    (mistake,) = parsed.diagnostics
    assert mistake.code == "number-too-large"
    assert mistake.place is not None
    assert (mistake.place.column, mistake.place.end_column) == (column, column + len(digits))
    assert len(mistake.message) < 100


@pytest.mark.parametrize("number", ["-1", "1.5", "+1", "0x10", "1e3", "٣", "½"])
def test_what_looks_like_a_number_elsewhere_is_none_here(number: str) -> None:
    assert not parse(f"a.b({number});").ok


def test_a_number_out_of_place_among_numbers_is_found_by_its_place() -> None:
    parsed = parse("a.b(65535, 65536, 65536);")
    assert [item.place.column for item in parsed.diagnostics if item.place] == [12, 19]


@pytest.mark.parametrize(
    "white",
    [" ", "\t", "\r\n", "\n", "\f", "\v", "\u00a0", "\u3000", "\u2028"],
    ids=["space", "tab", "crlf", "lf", "ff", "vt", "nbsp", "wide", "ls"],
)
def test_white_space_may_stand_between_all_words_and_at_both_ends(white: str) -> None:
    words = ["*", "[", "a", ".", "b", "(", "1", ",", "2", ")", "&", "!", "(", "c", ".", "d", "(", ")", ")", "]", "("]
    words += ["WAIT", "(", "3", ")", ";", ")", ";"]
    parsed = parse(white + white.join(words) + white * 3)
    assert parsed.diagnostics == []
    assert parsed.program == parse("*[a.b(1,2) & !(c.d())](WAIT(3););").program


@pytest.mark.parametrize("text", ["a.b();   ", "a.b();\t\t", "a.b();\n\n\n", "   \n\t ", "\f"])
def test_white_space_at_the_end_is_no_mistake(text: str) -> None:
    assert parse(text).diagnostics == []
