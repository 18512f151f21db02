"""The template of a sentence that a recording kept as finished English.

Recordings hold text, so that they can be read without KitRobot. A sentence is found again among the templates of the
context "recorded": it belongs to the one with the most letters of its own that fits; between two stretches of it a hole
takes as little as it can. What stood in a hole may be such a sentence too, a list of them, or clauses with semicolons
between them; else it is a name.

The work is bounded whatever a name may hold: stretches are looked for once each, from left to right, without going
back; longer texts than `LONGEST` are none of ours; sentences in sentences are looked at `DEEPEST` levels deep.
"""

from __future__ import annotations

import re
from functools import lru_cache

from kitrobot.text.sentences import COMMA, HOLE, SEMICOLON, Recorded, Sentence, Series
from kitrobot.translation.catalogue import Catalogue

LONGEST = 4000
DEEPEST = 4
REMEMBERED = 2048
_MOST_PARTS = 50
_JOINTS = re.compile(r", | and ")


@lru_cache(REMEMBERED)
def recalled(text: str, known: Catalogue) -> Sentence | None:
    """The sentence that the text is; None when it is made of none of our templates."""
    return _sentence(text, known, DEEPEST)


def _sentence(text: str, known: Catalogue, depth: int) -> Sentence | None:
    if depth == 0 or len(text) > LONGEST:
        return None
    for context in (Recorded, Sentence):
        if known.word(context.context, text) is not None:
            return context(text)
    for one, many, names, stretches in _templates(known):
        found = _holes(text, stretches)
        if found is None:
            continue
        values: list[object] = [_value(hole, known, depth - 1) for hole in found]
        if not many:
            return Recorded(one, *values)
        at = names.index("count")
        if found[at].isdecimal():
            values[at] = int(found[at])
            return Recorded.counted(one, many, *values)
    return None


def _value(text: str, known: Catalogue, depth: int) -> str:
    """What stands in a hole: a sentence, or a name."""
    return _clauses(text, known, depth) or _list(text, known, depth) or _sentence(text, known, depth) or text


def _clauses(text: str, known: Catalogue, depth: int) -> Sentence | None:
    """`a waits; b has no box`, when each clause is a sentence."""
    clauses = text.split("; ")
    if not 1 < len(clauses) <= _MOST_PARTS:
        return None
    made = [_list(one, known, depth) or _sentence(one, known, depth) for one in clauses]
    found = [one for one in made if one is not None]
    return Series(SEMICOLON, found) if len(found) == len(made) else None


def _list(text: str, known: Catalogue, depth: int) -> Sentence | None:
    """`a, b and c`, when each of them is one word or a sentence."""
    parts = _JOINTS.split(text)
    if not 1 < len(parts) <= _MOST_PARTS:
        return None
    made = [(_sentence(part, known, depth) if " " in part else None) or part for part in parts]
    if any(" " in part and not isinstance(part, Sentence) for part in made):
        return None
    return Sentence("{front} and {last}", Series(COMMA, made[:-1]), made[-1])


@lru_cache(4)
def _templates(known: Catalogue) -> list[tuple[str, str, list[str], list[str]]]:
    """The templates of recordings with holes, those with more letters of their own first.

    Returns: the template, the one for other counts than 1 ("" without), names of holes, stretches between them.
    """
    found = []
    for (context, one), many in known.plurals.items():
        if context == Recorded.context and HOLE.search(one):
            for form in dict.fromkeys((one, many) if many else (one,)):
                pieces = HOLE.split(form)
                found.append((one, many, pieces[1::2], pieces[::2]))
    return sorted(found, key=lambda one: -sum(map(len, one[3])))


def _holes(text: str, stretches: list[str]) -> list[str] | None:
    """What stands in the holes when the text is this template."""
    first, *middle, last = stretches
    if not text.startswith(first) or not text.endswith(last) or len(text) < len(first) + len(last):
        return None
    at, end = len(first), len(text) - len(last)
    found = []
    for stretch in middle:
        begin = text.find(stretch, at, end)
        if begin < 0:
            return None
        found.append(text[at:begin])
        at = begin + len(stretch)
    return [*found, text[at:end]]
