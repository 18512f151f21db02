"""Any text at all is read to its end: no exception, no hang, every place inside the text."""

from __future__ import annotations

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from kitrobot.lll.formatter import format_text
from kitrobot.lll.parse_results import parse, parse_template
from kitrobot.lll.printer import print_program
from kitrobot.lll.tokens import is_name
from tests.effort import THOROUGH

WORDS = [
    *("a.b()", "a.b(1, 2)", "a.b(c.d())", "a", "b", ".", "(", ")", "[", "]", "<", ">", "*", "//", "/", "!", "&", "|"),
    *(",", ";", "°", "\u00ba", "3", "99999", "WAIT", "WAIT(3)", "BREAK", "# c\n", "#", "\n", " ", "\t", "\r\n", "{h}"),
    *(
        "{",
        "}",
        "§",
        "-",
        "नमस्ते",
        "پہیہ",
        "\ufeff",
        "\x00",
        "\x0c",
        "\u2028",
        "°a.b()°",
        "2*(",
        "*[a.b()](",
        "[(",
        ")(",
    ),
]

PROGRAM = """\
# go
2*(
  [A.b(1) & !(C.d() | E.f())](  # if so
    °E.f(G.h(), 3)°;
  )!( WAIT(4); );
);
//(
  <A.b()>( BREAK; );,  # one
  *[پہیہ.آگے()]();
  # end
);
"""


def is_sound(text: str) -> None:
    """What holds of every text."""
    parsed = parse(text)
    lines = text.split("\n")
    for item in parsed.diagnostics:
        place = item.place
        assert place is not None
        assert item.message
        assert item.message.isprintable() or not text.isprintable()
        assert 1 <= place.line <= place.end_line <= len(lines)
        assert 1 <= place.column <= len(lines[place.line - 1]) + 1
        assert 1 <= place.end_column <= len(lines[place.end_line - 1]) + 1
        assert (place.line, place.column) <= (place.end_line, place.end_column)
    assert len({(item.place, item.message) for item in parsed.diagnostics}) == len(parsed.diagnostics)
    printed = print_program(parsed.program)
    if parsed.ok:
        again = parse(printed)
        assert again.diagnostics == []
        assert again.program == parsed.program
        assert format_text(printed)[0] == printed
    parse_template(text)
    is_name(text)


def test_a_program_cut_off_anywhere_is_read_as_far_as_it_goes() -> None:
    between = range(PROGRAM.index(");\n//(") + 1, PROGRAM.index("//(") + 1)
    for length in range(len(PROGRAM) + 1):
        text = PROGRAM[:length]
        is_sound(text)
        parsed = parse(text)
        assert len(parsed.diagnostics) <= 2, text
        assert all(item.is_error for item in parsed.diagnostics), text
        assert parsed.ok == (length in between or not len("# go\n") < length < len(PROGRAM) - 2), text


def test_a_program_with_any_character_left_out_is_read_and_told_in_few_words() -> None:
    told = []
    for position in range(len(PROGRAM)):
        text = PROGRAM[:position] + PROGRAM[position + 1 :]
        is_sound(text)
        told.append(len(parse(text).diagnostics))
    assert max(told) <= 8  # a bracket left out is told where it is missed, and where its partner is too many
    assert sum(told) / len(told) < 0.9


def test_a_program_with_any_character_put_in_anywhere_is_read() -> None:
    """Each character at every third place, at each place a third of them; in the thorough profile all of it."""
    step = 1 if THOROUGH else 3
    for number, character in enumerate("()[]<>*/!&|,;.°#{}7a §\n"):
        for position in range(number % step, len(PROGRAM), step):
            is_sound(PROGRAM[:position] + character + PROGRAM[position:])


@given(st.lists(st.sampled_from(WORDS), max_size=40).map("".join))
@example("A\n)")
@example("{h};")
@example("[[(a.b()](")
def test_any_row_of_words_is_read(text: str) -> None:
    is_sound(text)


@given(st.text(max_size=200))
@example("\ufeffa.b();")
@example("\ud800")
@example("a\u200db.c();")
def test_any_text_is_read(text: str) -> None:
    is_sound(text)


@given(st.binary(max_size=300))
def test_any_bytes_taken_for_text_are_read(data: bytes) -> None:
    is_sound(data.decode("latin-1"))


@given(st.integers(0, len(PROGRAM)), st.integers(0, len(PROGRAM)), st.sampled_from(WORDS))
def test_a_program_with_a_stretch_replaced_is_read(start: int, end: int, word: str) -> None:
    is_sound(PROGRAM[: min(start, end)] + word + PROGRAM[max(start, end) :])


@pytest.mark.parametrize(
    "filling", ["a.b(1,", "{", "a ", "a" * 50, "1 ,", "\n", " ", "#\n", ";", "°", "a.b()#x\n", "(" * 9]
)
def test_a_long_text_takes_time_in_its_length_only(filling: str) -> None:
    text = filling * (10_000 // len(filling))
    parse(text)
    tree, _ = parse_template("[a.b()](" + text)
    assert tree is None
