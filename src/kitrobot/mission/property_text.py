"""A property as one line of text, as people type it behind a command.

    never A                     never A while B
    eventually A                A                        (the same)
    after A eventually B        A before B
    stays A until B             holds A for 5 s
    at most 3 times A           again and again A; B
    visit A; B; C               visit A; B; C in this order        visit A; B; C in turn

Behind it may stand `within SECONDS`. A, B and C are conditions; a word such as *until* counts outside their brackets
only, and not where it names an agent. Places in messages are characters, counted from 1.
"""

from __future__ import annotations

import math
import re
from collections.abc import Collection
from dataclasses import dataclass, replace
from typing import Final

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.mission.property_forms import (
    LISTS,
    MOST_PLACES,
    MOST_TIMES,
    TIMED,
    AskedProperty,
    Form,
    VisitOrder,
    split_conditions,
)
from kitrobot.mission.trial import LONGEST_CONDITION, LONGEST_S
from kitrobot.text.phrases import shown
from kitrobot.text.sentences import Help, Sentence

LONGEST_TEXT: Final = 2 * LONGEST_CONDITION + 100
_WORD = re.compile(r"\S+")
_BEGINS: Final = ("never", "eventually", "after", "stays", "holds", "at", "again", "visit")
_LINKS: Final = {"never": "while", "after": "eventually", "stays": "until"}
_QUANTIFIERS: Final = ("any", "all", "most")
_EXAMPLE: Final = Sentence("ask one like `delivered within 120` or `never any carrier (Collision.IsPressed())`")
_ORDERS: Final = {
    ("in", "any", "order"): VisitOrder.ANY,
    ("in", "this", "order"): VisitOrder.GIVEN,
    ("in", "turn"): VisitOrder.TURN,
}


class QuestionError(KitRobotError):
    """A question that no run can answer."""


def words_within(words: Sentence, within_s: float | None) -> Sentence:
    """What is demanded, with the time that a question sets; None for none."""
    return words if within_s is None else Sentence("{question}, within {seconds} s", words, f"{within_s:g}")


@dataclass(frozen=True, slots=True)
class PropertyText:
    """What a line of text asks for.

    Attributes:
        text: as it was asked, without needless blanks.
        name: of a property or an outcome, "" where `asked` says what is asked.
        asked: a property in one of its forms, which is called *asked*.
        within_s: simulated seconds after which a run is not looked at any more; None where the text sets none, or the
            form has a time of its own.
    """

    text: str
    name: str = ""
    asked: AskedProperty | None = None
    within_s: float | None = None


@dataclass(frozen=True, slots=True)
class _Token:
    """A word outside brackets, and where it begins; `names` where it says which agents are meant."""

    word: str
    start: int
    names: bool


def read_property(text: str) -> PropertyText:
    """Reads a property, or the name of one.

    Raises:
        QuestionError: it is empty or too long, a word is missing, or a number makes no sense.
    """
    text = " ".join(text.split())
    if not text:
        raise QuestionError(Sentence("there is no question"), _EXAMPLE)
    if len(text) > LONGEST_TEXT:
        raise QuestionError(
            Sentence("expected at most {longest} characters in a question, found {count}", LONGEST_TEXT, len(text)),
            Sentence("put a longer property into the mission, and ask by its name"),
        )
    body, within = _cut_time(text, "within")
    found = _read_form(body)
    if found is None:
        if "(" not in body and " " not in body:
            return PropertyText(text, body, None, within)
        found = AskedProperty("asked", Form.EVENTUALLY, body)
    if found.form in LISTS:
        _check_list(found)
    if within is not None and found.form in TIMED:
        if found.form is Form.HOLDS:
            raise QuestionError(
                Sentence("`holds` has two times: {text}", shown(text)), Sentence("leave out within and its number")
            )
        return PropertyText(text, "", replace(found, seconds=within))
    return PropertyText(text, "", found, within)


def read_question(text: str, names: Collection[str]) -> PropertyText:
    """As `read_property`; a text that is one of these names, of properties of a mission, is that name, whatever its
    words are.
    """
    return PropertyText(text, text) if text in names else read_property(text)


def _read_form(body: str) -> AskedProperty | None:
    """The property, without its time; None for a condition or a name alone."""
    tokens = _tokens(body)
    if len(tokens) < 2 or tokens[0].word not in _BEGINS:
        link = next((one for one in tokens[1:] if one.word == "before" and not one.names), None)
        return None if link is None else _linked(Form.BEFORE, body, 0, link)
    first, at = tokens[0].word, tokens[0].start + len(tokens[0].word)
    match first:
        case "eventually":
            return AskedProperty("asked", Form.EVENTUALLY, body[at:].strip())
        case "never" | "after" | "stays":
            link = next((one for one in tokens[1:] if one.word == _LINKS[first] and not one.names), None)
            if link is not None:
                return _linked(Form(first), body, at, link)
            if first == "never":
                return AskedProperty("asked", Form.NEVER, body[at:].strip())
            raise _missing(_LINKS[first], first, body)
        case "holds":
            rest, seconds = _cut_time(body, "for")
            if seconds is None:
                raise _missing("for", first, body)
            return AskedProperty("asked", Form.HOLDS, rest[at:].strip(), seconds=seconds)
        case "at":
            return _at_most(tokens, body)
        case "again":
            if [one.word for one in tokens[:3]] != ["again", "and", "again"]:
                raise _missing("and again", first, body)
            return AskedProperty("asked", Form.AGAIN, body[tokens[2].start + len("again") :].strip())
        case _:
            return _visit(tokens, body, at)


def _linked(form: Form, body: str, at: int, link: _Token) -> AskedProperty:
    """A property of two conditions with a word between them."""
    first, second = body[at : link.start].strip(), body[link.start + len(link.word) :].strip()
    for condition, side in ((first, Sentence("before")), (second, Sentence("behind"))):
        if not condition:
            raise QuestionError(
                Sentence("expected a condition {side} `{word}`, at character {place}", side, link.word, link.start + 1),
                _EXAMPLE,
            )
    return AskedProperty("asked", form, first, second)


def _at_most(tokens: list[_Token], body: str) -> AskedProperty:
    words = [one.word for one in tokens[:4]]
    if words[:2] != ["at", "most"]:
        raise _missing("most", "at", body)
    if len(words) < 4 or words[3] not in ("times", "time"):
        raise _missing("times", "at most", body)
    if not (words[2].isascii() and words[2].isdigit() and len(words[2]) < 6 and int(words[2]) <= MOST_TIMES):
        raise QuestionError(
            Sentence(
                "expected a whole number from 0 to {most} behind `at most`, found {found} at character {place}",
                *(MOST_TIMES, shown(words[2]), tokens[2].start + 1),
            ),
            Sentence("write one like `at most 3 times any carrier (Collision.IsPressed())`"),
        )
    rest = body[tokens[3].start + len(words[3]) :].strip()
    return AskedProperty("asked", Form.AT_MOST, rest, times=int(words[2]))


def _visit(tokens: list[_Token], body: str, at: int) -> AskedProperty:
    for words, order in _ORDERS.items():
        last = tokens[-len(words) :]
        if tuple(one.word for one in last) == words:
            return AskedProperty("asked", Form.VISIT, body[at : last[0].start].strip(), order=order)
    return AskedProperty("asked", Form.VISIT, body[at:].strip())


def list_mistake(one: AskedProperty) -> tuple[Sentence, Help] | None:
    """What is wrong with the list of conditions of a form that has one; None for nothing."""
    found = split_conditions(one.first)
    if len(found) > MOST_PLACES:
        return (
            Sentence("expected at most {most} conditions in a list, found {count}", MOST_PLACES, len(found)),
            Sentence("make two properties of it"),
        )
    for number, condition in enumerate(found, 1):
        if not condition:
            return (
                Sentence("condition {number} of the list is empty", number),
                Sentence("write conditions with one semicolon between two of them"),
            )
        if found.index(condition) < number - 1:
            return (
                Sentence("condition {number} of the list, {condition}, is there already", number, shown(condition)),
                Sentence("name each place once; `in turn` goes round again by itself"),
            )
    return None


def _check_list(one: AskedProperty) -> None:
    mistake = list_mistake(one)
    if mistake is not None:
        raise QuestionError(*mistake)


def _missing(word: str, behind: str, body: str) -> QuestionError:
    return QuestionError(
        Sentence("expected `{word}` behind `{behind}`, found none in {text}", word, behind, shown(body)), _EXAMPLE
    )


def _cut_time(text: str, word: str) -> tuple[str, float | None]:
    """The text without `word SECONDS` at its end, and those seconds."""
    tokens = _tokens(text)
    if tokens and tokens[-1].word == "s":
        tokens.pop()
    if len(tokens) < 2 or tokens[-2].word != word or tokens[-2].names or tokens[-2].start == 0:
        return text, None
    return text[: tokens[-2].start].strip(), _seconds(tokens[-1], word)


def _seconds(token: _Token, word: str) -> float:
    try:
        seconds = float(token.word.removesuffix("s"))
    except ValueError:
        seconds = math.nan
    if not 0 < seconds <= LONGEST_S:
        raise QuestionError(
            Sentence("expected seconds behind {word}, found {found}", word, shown(token.word)),
            Sentence("write a number larger than 0, as in `delivered within 120`"),
        )
    return seconds


def _tokens(text: str) -> list[_Token]:
    """The words outside brackets."""
    flat, depth = [], 0
    for sign in text:
        depth = max(0, depth - (sign in ")}]"))
        flat.append(" " if depth or sign in "(){}[]" else sign)
        depth += sign in "({["
    found: list[_Token] = []
    for part in _WORD.finditer("".join(flat)):
        names = bool(found) and found[-1].word in _QUANTIFIERS and not found[-1].names
        found.append(_Token(part[0], part.start(), names and text[part.end() :].lstrip()[:1] == "("))
    return found
