"""Sentences for people: English text that keeps the template and the values that it was made of.

A `Sentence` is a `str`, so it is printed, compared and joined as its English text. `kitrobot.translation` looks its
template up in the reader's language and fills the values in again: those that are sentences are translated, others are
names, numbers or code and stay as they are. Whatever makes a plain `str` of it (an f-string, `+`, a method of `str`)
loses the template, so a sentence is put into another one as a value.

Templates are the keys of the catalogues. `tools/sentences.py` finds them in the source, so they are literals where a
`Sentence`, `Sentence.counted` or `Recorded` is made; `Word` is for words that come from elsewhere, `Label` for names
that come with their translations.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from functools import lru_cache
from typing import Literal, Self

HOLE = re.compile(r"\{([a-z]\w*)\}")
"""Where a template is filled in: `{name}`."""


class Sentence(str):
    """A sentence, or a part of one: `Sentence("the robot `{robot}` has no `{part}`", robot.name, part.name)`.

    Values are given in the order in which the template names them first; without values, braces are text.

    Attributes:
        template: the English text with its holes.
        plural: the template for other numbers than one, "" where the sentence counts nothing.
        values: what stands in the holes, by name; `count` is what a sentence with a plural counts.
    """

    __slots__ = ("plural", "template", "values")

    context = ""
    """Which entries of a catalogue it is looked up among (gettext's msgctxt)."""

    template: str
    plural: str
    values: dict[str, object]

    def __new__(cls, template: str, /, *values: object) -> Self:
        if not values:
            return cls._made(template, "", template, {})
        named = dict(zip(_names(template), values, strict=True))
        return cls._made(template, "", filled(template, named), named)

    @classmethod
    def counted(cls, one: str, many: str, /, *values: object) -> Self:
        """A sentence that counts: `one` is its template where the value of `{count}` is 1, `many` for other numbers.

        The values are in the order of `many`.
        """
        named = dict(zip(_names(many), values, strict=True))
        return cls._made(one, many, filled(one if named["count"] == 1 else many, named), named)

    def with_value(self, name: str, value: object) -> Self:
        """The same sentence with something else in one of its holes."""
        values = {**self.values, name: value}
        many = self.plural and values["count"] != 1
        return self._made(self.template, self.plural, filled(self.plural if many else self.template, values), values)

    @classmethod
    def _made(cls, template: str, plural: str, english: str, values: dict[str, object]) -> Self:
        made = str.__new__(cls, english)
        made.template = template
        made.plural = plural
        made.values = values
        return made


class Word(Sentence):
    """A word that comes from elsewhere (a kind of part, what the system says) and may be known to the catalogues."""

    __slots__ = ()
    context = "word"

    def __new__(cls, word: object) -> Self:
        return cls._made(str(word), "", str(word), {})


class Label(Sentence):
    """What data calls something, in several languages: in `texts`, "" is English. Without any it is `name`."""

    __slots__ = ("name", "texts")

    name: str
    texts: Mapping[str, str]

    def __new__(cls, name: str, texts: Mapping[str, str]) -> Self:
        english = texts.get("") or name
        made = cls._made(english, "", english, {})
        made.name, made.texts = name, texts
        return made

    def __reduce__(self) -> tuple[object, ...]:
        return Label, (self.name, dict(self.texts))


class Recorded(Sentence):
    """A sentence that recordings keep as finished English.

    A reader of recordings makes one of the whole text; the catalogues find the template again by matching it.
    """

    __slots__ = ()
    context = "recorded"


class Series(Sentence):
    """Several values with the same sign between them: `Series(COMMA, names)`; `parts` are its values."""

    __slots__ = ("parts",)

    parts: tuple[str, ...]

    def __new__(cls, sign: Sentence, parts: Iterable[str]) -> Self:
        kept = tuple(parts)
        made = cls._made(sign.template, "", sign.join(kept), {})
        made.parts = kept
        return made

    def __reduce__(self) -> tuple[object, ...]:
        return Series, (Sentence(self.template), self.parts)


Help = Sentence | Literal[""]
"""A way out that a message offers, or none."""

COMMA = Sentence(", ")
SEMICOLON = Sentence("; ")


def clipped(text: str, most: int) -> str:
    """The first letters of a text, at most so many; one that is short enough as it is, a sentence with its template."""
    return text if len(text) <= most else text[:most]


def filled(template: str, values: dict[str, object]) -> str:
    """A template with its values; a hole without one stays."""
    return HOLE.sub(lambda hole: str(values[hole[1]]) if hole[1] in values else hole[0], template)


@lru_cache(4096)
def _names(template: str) -> tuple[str, ...]:
    """The names of a template's holes, each once."""
    return tuple(dict.fromkeys(HOLE.findall(template)))
