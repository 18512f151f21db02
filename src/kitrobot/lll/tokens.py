"""Text → tokens, in one pass of one regular expression.

A token is a tuple (kind, start, end, text): a kind is one of the constants below. A call with nothing but numbers
(`Wheel.Advance(50)`) is one token of its own, CALL, because most of every program is made of them; in place of its text
it has (object, method, where the method starts, numbers or None, where they start). Comments are kept apart, each with
the index of the token that follows it.

Names are in their one form (`kitrobot.text.name_form`): é is one name, however a keyboard has typed it. What only looks
like signs and digits (`lookalikes`) is read as what it looks like, and listed. A brace is a token.

A text with a word of the team's language has two tokens more: a NAME whose parts are joined by single hyphens
(`carrier-2`; not before a dot, since no object has such a name), and QUOTED, any name between double quotes, in which
two quotes stand for one. `=` and `:` are tokens of their own there.

Left to others: what may follow what (parser).
"""

from __future__ import annotations

import re
import unicodedata
from functools import cache
from typing import Any, NamedTuple

from kitrobot.lll.lookalikes import plain
from kitrobot.lll.tree import QUANTIFIERS
from kitrobot.text.forms import name_form

CALL, NAME, NUMBER, HOLE, SYMBOL, OTHER, END, QUOTED = range(8)

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


def _pattern(name: str, part: str, *, team: bool) -> re.Pattern[str]:
    """`part` is what a name goes on with behind a hyphen."""
    joined = rf"(?:(?:-(?:{part})++)++(?!\s*\.))?" if team else ""
    more = r"""| (?P<quoted>"(?:[^"\r\n]|"")*") | (?P<sign>[=:](?!=))""" if team else ""
    return re.compile(
        rf"""\s*+(?:
          (?P<call>({name})\s*\.\s*({name})\s*\(\s*([0-9]+(?:\s*,\s*[0-9]+)*)?\s*\))
        | (?P<name>{name}{joined})
        | (?P<symbol>//|[;,()\[\]<>!&|*.])
        | (?P<number>[0-9]+)
        | (?P<comment>\#[^\r\n]*)
        | (?P<mark>[{_MARKS_READ}])
        | (?P<hole>\{{\s*{name}\s*\}})
        {more}
        | (?P<other>[{{}}]|[^\s{{}};,()\[\]<>!&|*.{_MARKS_READ}\#]+)
        | \Z
        )""",
        re.VERBOSE,
    )


@cache
def _ascii(*, team: bool = False) -> re.Pattern[str]:
    return _pattern(r"[A-Za-z_][A-Za-z0-9_]*", "[A-Za-z0-9_]", team=team)


@cache
def _unicode(*, team: bool = False) -> re.Pattern[str]:
    r"""Names in any script: a word of `re` has letters, but not the vowel signs that many scripts add.

    `\w` takes numerals too (², Ⅷ, ①), which `\d` does not: a name does not start with one. U+00BA, read as a mark,
    counts as a letter.
    """
    characters = [chr(code) for code in range(0x80, 0x1F200)]
    marks = "".join(one for one in characters if unicodedata.category(one) in ("Mn", "Mc"))
    numerals = "".join(one for one in characters if one.isalnum() and not one.isalpha())
    part = rf"[^\W\u00ba]|[{marks}]"
    return _pattern(rf"[^\W\d\u00ba{numerals}](?:{part})*", part, team=team)


def _without_marks(text: str) -> str:
    for mark in _MARKS_READ:
        text = text.replace(mark, "")
    return text


def is_name(text: str) -> bool:
    """Whether a text is an IDENT of the grammar (and no reserved word)."""
    return _is_one_name(tokenise(text, team=False).tokens, text) and text not in RESERVED


RESERVED = frozenset({"WAIT", "BREAK"})

TEAM_FORMS = frozenset({"SeqOfPar", "ParOfSeq", "Where", "PROGRAM", "MOVE"})
TEAM_DECLARATIONS = frozenset({"role", "group", "work"})
TEAM_WORDS = TEAM_FORMS | TEAM_DECLARATIONS | frozenset(QUANTIFIERS)
"""The words of a team's language; names where a dot follows."""


def team_name(name: str) -> str:
    """A name as a team's program writes it: bare if its parts are joined by single hyphens, else between quotes."""
    if _is_one_name(tokenise(name, team=True).tokens, name):
        return name
    return '"' + " ".join(name.split("\n")).replace('"', '""') + '"'


def _is_one_name(tokens: list[Token], text: str) -> bool:
    return len(tokens) == 2 and tokens[0][:3] == (NAME, 0, len(text))


def tokenise(text: str, *, team: bool | None = None) -> Tokens:
    """The tokens and comments of a text; never fails: what is no token is one of kind OTHER.

    `team`: whether with the tokens of a team's language; if not given, where one of its words is a token.
    """
    tokens: list[Token] = []
    comments: list[Comment] = []
    lookalikes: list[tuple[int, int, str]] = []
    add = tokens.append
    pattern = (_ascii if _without_marks(text).isascii() else _unicode)(team=bool(team))
    kinds = {"name": NAME, "number": NUMBER, "other": OTHER, "sign": OTHER}
    for match in pattern.finditer(text):
        group = match.lastgroup
        if group == "symbol":
            start, end = match.span(group)
            add((SYMBOL, start, end, match[group]))
        elif group == "call":
            start, end = match.span(group)
            names = name_form(match[2]), name_form(match[3])
            add((CALL, start, end, (*names, match.start(3), match[4], match.start(4))))
        elif group == "comment":
            start, body = match.start(group), match[group][1:].rstrip()
            comments.append(Comment(start, body[1:] if body[:1] == " " else body, len(tokens)))
        elif group == "mark":
            add((SYMBOL, match.start(group), match.end(), MARK))
        elif group == "hole":
            add((HOLE, match.start(group), match.end(), name_form(match[group][1:-1].strip())))
        elif group == "quoted":
            start, end = match.span(group)
            add((QUOTED, start, end, name_form(match[group][1:-1].replace('""', '"'))))
        elif group == "other" and (meant := plain(match[group])) != match[group]:
            start, end = match.span(group)
            lookalikes.append((start, end, meant))
            tokens += [
                (kind, start + a, start + b, text) for kind, a, b, text in tokenise(meant, team=team).tokens[:-1]
            ]
        elif group == "name" and team is None and match[group] in TEAM_WORDS:
            return tokenise(text, team=True)
        elif group is not None:
            found = name_form(match[group]) if group == "name" else match[group]
            add((kinds[group], match.start(group), match.end(), found))
    add((END, len(text), len(text), ""))
    return Tokens(tokens, comments, lookalikes)
