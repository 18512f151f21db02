"""Text → tokens, in one pass of one regular expression.

A token is a tuple (kind, start, end, text): a kind is one of the constants below. A call with nothing but numbers
(`Wheel.Advance(50)`) is one token of its own, CALL, because most of every program is made of them; in place of its text
it has (object, method, where the method starts, numbers or None, where they start). Comments are kept apart, each with
the index of the token that follows it.

What only looks like signs and digits (`lookalikes`) is read as what it looks like, and listed. A brace is a token.

Left to others: what may follow what (parser).
"""

from __future__ import annotations

import re
import unicodedata
from functools import cache
from typing import Any, NamedTuple

from kitrobot.lll.lookalikes import plain

CALL, NAME, NUMBER, HOLE, SYMBOL, OTHER, END = range(7)

Token = tuple[int, int, int, Any]

MARK = "°"
_MARKS_READ = "\u00b0\u00ba\u02da"


class Comment(NamedTuple):
    """A comment: where its `#` stands, its text without it, and which token comes next."""

    start: int
    text: str
    before: int


class Tokens(NamedTuple):
    """All tokens of a text, closed by one END token, its comments, and what stands for other characters.

    Of each of the latter: where it starts and ends, and what it looks like.
    """

    tokens: list[Token]
    comments: list[Comment]
    lookalikes: list[tuple[int, int, str]]


def _pattern(name: str) -> re.Pattern[str]:
    return re.compile(
        rf"""\s*+(?:
          (?P<call>({name})\s*\.\s*({name})\s*\(\s*([0-9]+(?:\s*,\s*[0-9]+)*)?\s*\))
        | (?P<name>{name})
        | (?P<symbol>//|[;,()\[\]<>!&|*.])
        | (?P<number>[0-9]+)
        | (?P<comment>\#[^\n]*)
        | (?P<mark>[{_MARKS_READ}])
        | (?P<hole>\{{\s*{name}\s*\}})
        | (?P<other>[{{}}]|[^\s{{}};,()\[\]<>!&|*.{_MARKS_READ}\#]+)
        | \Z
        )""",
        re.VERBOSE,
    )


@cache
def _ascii() -> re.Pattern[str]:
    return _pattern(r"[A-Za-z_][A-Za-z0-9_]*")


@cache
def _unicode() -> re.Pattern[str]:
    r"""Names in any script: a word of `re` has letters, but not the vowel signs that many scripts add.

    `\w` takes numerals too (², Ⅷ, ①), which `\d` does not: a name does not start with one. U+00BA, read as a mark,
    counts as a letter.
    """
    characters = [chr(code) for code in range(0x80, 0x1F200)]
    marks = "".join(one for one in characters if unicodedata.category(one) in ("Mn", "Mc"))
    numerals = "".join(one for one in characters if one.isalnum() and not one.isalpha())
    return _pattern(rf"[^\W\d\u00ba{numerals}](?:[^\W\u00ba]|[{marks}])*")


def _without_marks(text: str) -> str:
    for mark in _MARKS_READ:
        text = text.replace(mark, "")
    return text


def is_name(text: str) -> bool:
    """Whether a text is an IDENT of the grammar (and no reserved word)."""
    tokens = tokenise(text).tokens
    return len(tokens) == 2 and tokens[0][:3] == (NAME, 0, len(text)) and text not in RESERVED


RESERVED = frozenset({"WAIT", "BREAK"})


def tokenise(text: str) -> Tokens:
    """The tokens and comments of a text; never fails: what is no token is one of kind OTHER."""
    tokens: list[Token] = []
    comments: list[Comment] = []
    lookalikes: list[tuple[int, int, str]] = []
    add = tokens.append
    pattern = _ascii() if _without_marks(text).isascii() else _unicode()
    kinds = {"name": NAME, "number": NUMBER, "other": OTHER}
    for match in pattern.finditer(text):
        group = match.lastgroup
        if group == "symbol":
            start, end = match.span(group)
            add((SYMBOL, start, end, match[group]))
        elif group == "call":
            start, end = match.span(group)
            add((CALL, start, end, (match[2], match[3], match.start(3), match[4], match.start(4))))
        elif group == "comment":
            start, body = match.start(group), match[group][1:].rstrip()
            comments.append(Comment(start, body[1:] if body[:1] == " " else body, len(tokens)))
        elif group == "mark":
            add((SYMBOL, match.start(group), match.end(), MARK))
        elif group == "hole":
            add((HOLE, match.start(group), match.end(), match[group][1:-1].strip()))
        elif group == "other" and (meant := plain(match[group])) != match[group]:
            start, end = match.span(group)
            lookalikes.append((start, end, meant))
            tokens += [(kind, start + a, start + b, text) for kind, a, b, text in tokenise(meant).tokens[:-1]]
        elif group is not None:
            add((kinds[group], match.start(group), match.end(), match[group]))
    add((END, len(text), len(text), ""))
    return Tokens(tokens, comments, lookalikes)
