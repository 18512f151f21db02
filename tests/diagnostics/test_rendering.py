"""What a person reads: the sentence, the line, the caret under the guilty place, the help."""

from __future__ import annotations

from typing import NamedTuple

import pytest

from kitrobot.diagnostics.model import Diagnostic, Place, Severity, Source
from kitrobot.diagnostics.renderer import render, render_one
from kitrobot.lll.parse_results import parse
from kitrobot.text.sentences import Sentence


class Case(NamedTuple):
    text: str
    start: int
    end: int
    shown: str


def error(source: Source, start: int, end: int, help: str = "") -> Diagnostic:
    return Diagnostic("a-code", Severity.ERROR, Sentence("this is wrong"), source.place(start, end), Sentence(help))


CASES = {
    "a word": Case(
        "let me go\n",
        4,
        6,
        """\
f.lll:1:5: error: this is wrong [a-code]
  1 | let me go
          ^^""",
    ),
    "a line further down": Case(
        "\n" * 99 + "  stop;\n",
        101,
        105,
        """\
f.lll:100:3: error: this is wrong [a-code]
  100 |   stop;
          ^^^^""",
    ),
    "an empty place": Case(
        "a.b() c.d()",
        5,
        5,
        """\
f.lll:1:6: error: this is wrong [a-code]
  1 | a.b() c.d()
           ^""",
    ),
    "the end of the text": Case(
        "a.b(",
        4,
        4,
        """\
f.lll:1:5: error: this is wrong [a-code]
  1 | a.b(
          ^""",
    ),
    "the line break": Case(
        "a.b(\nc",
        4,
        5,
        """\
f.lll:1:5: error: this is wrong [a-code]
  1 | a.b(
          ^""",
    ),
    "an empty line": Case(
        "",
        0,
        0,
        """\
f.lll:1:1: error: this is wrong [a-code]
  1 |
      ^""",
    ),
    "more than one line": Case(
        "go 2*(\n  x\n);\n",
        3,
        12,
        """\
f.lll:1:4: error: this is wrong [a-code]
  1 | go 2*(
         ^^^""",
    ),
    "tabs": Case(
        "\t\tgo\tnow",
        5,
        8,
        """\
f.lll:1:6: error: this is wrong [a-code]
  1 |   go now
           ^^^""",
    ),
    "windows line ends": Case(
        "a\r\nbad\r\nc",
        3,
        6,
        """\
f.lll:2:1: error: this is wrong [a-code]
  2 | bad
      ^^^""",
    ),
    "wide letters": Case(
        "車.前進(五);",
        5,
        6,
        """\
f.lll:1:6: error: this is wrong [a-code]
  1 | 車.前進(五);
              ^^""",
    ),
    "marks upon letters": Case(
        "e\u0301t. x",
        5,
        6,
        """\
f.lll:1:6: error: this is wrong [a-code]
  1 | e\u0301t. x
          ^""",
    ),
    "vowel signs": Case(
        "गाड़ी.x",
        6,
        7,
        """\
f.lll:1:7: error: this is wrong [a-code]
  1 | गाड़ी.x
           ^""",
    ),
    "writing from right to left": Case(
        "پہیہ.آگے(5);",
        9,
        10,
        """\
f.lll:1:10: error: this is wrong [a-code]
  1 | پہیہ.آگے(5);
               ^""",
    ),
    "what would steer a terminal": Case(
        "a\x1b[31m\x07\u202eb",
        8,
        9,
        """\
f.lll:1:9: error: this is wrong [a-code]
  1 | a\ufffd[31m\ufffd\ufffdb
              ^""",
    ),
}


@pytest.mark.parametrize("case", CASES.values(), ids=CASES.keys())
def test_the_caret_stands_under_the_guilty_place(case: Case) -> None:
    source = Source("f.lll", case.text)
    assert render_one(error(source, case.start, case.end), source) == case.shown


@pytest.mark.parametrize(("start", "end"), [(5, 8), (155, 162), (300, 303), (997, 1000), (200, 900)])
def test_of_a_long_line_only_the_part_around_the_place_is_shown(start: int, end: int) -> None:
    source = Source("f.lll", "0123456789" * 100)
    _, line, caret = render_one(error(source, start, end), source).split("\n")
    assert len(line) <= len("  1 | ") + 160
    at = caret.index("^")
    assert line[at] == source.text[start]
    width = caret.count("^")
    shown = line[at : at + width]
    assert shown == source.text[start : start + width]
    assert width == min(end - start, len(line) - at)


def test_help_stands_on_its_own_line() -> None:
    source = Source("f.lll", "go")
    assert render_one(error(source, 0, 2, "do not go"), source).endswith("^^\n  help: do not go")


def test_what_has_no_place_is_a_sentence() -> None:
    hint = Diagnostic("a-code", Severity.HINT, Sentence("think again"), help=Sentence("twice"))
    assert render_one(hint, None) == "hint: think again [a-code]\n  help: twice"


def test_without_the_text_there_is_no_caret() -> None:
    warning = Diagnostic("a-code", Severity.WARNING, Sentence("odd"), Place("f.xml", 3, 4, 3, 5))
    assert render_one(warning, None) == "f.xml:3:4: warning: odd [a-code]"


def test_a_place_behind_the_text_shows_an_empty_line() -> None:
    beyond = Diagnostic("a-code", Severity.ERROR, Sentence("odd"), Place("f.lll", 9, 3, 9, 4))
    assert render_one(beyond, Source("f.lll", "go")).split("\n")[1] == "  9 |"


def test_several_are_rendered_each_with_its_own_file() -> None:
    one, two = Source("one.lll", "first"), Source("two.lll", "second")
    found = [error(one, 0, 5), error(two, 0, 6), Diagnostic("a-code", Severity.HINT, Sentence("think"))]
    assert render(found, {"one.lll": one}) == "\n".join(
        [
            "one.lll:1:1: error: this is wrong [a-code]",
            "  1 | first",
            "      ^^^^^",
            "two.lll:1:1: error: this is wrong [a-code]",
            "hint: think [a-code]",
        ]
    )


def test_nothing_wrong_is_nothing_to_read() -> None:
    assert render([], {}) == ""


def test_a_mistake_of_a_program_reads_like_this() -> None:
    parsed = parse("2*(\n  Wheel.Advance(5O);\n);\nDoor.Open() Door.Close();\n", "mine.lll")
    assert (
        render(parsed.diagnostics, {"mine.lll": parsed.source})
        == """\
mine.lll:2:18: error: expected `,` or `)` after a parameter, found a name `O` [syntax]
  2 |   Wheel.Advance(5O);
                       ^
mine.lll:4:12: hint: expected `;` between two instructions [missing-semicolon]
  4 | Door.Open() Door.Close();
                 ^
  help: put a `;` here"""
    )


def test_a_message_is_one_line_whatever_is_in_it() -> None:
    told = Diagnostic(
        "a-code", Severity.ERROR, Sentence("found `\n\x1b[2J`"), Place("a\nb.lll"), Sentence("write\rthis")
    )
    assert len(render_one(told, None).split("\n")) == 2
    assert render_one(told, None).isprintable() or "\x1b" not in render_one(told, None)
