"""Messages as the page shows them: sentences of their own, in the reader's language."""

from __future__ import annotations

import re
from typing import Annotated

from pydantic import PlainSerializer, SkipValidation, ValidationError

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.text.sentences import Sentence, Series
from kitrobot.translation.languages import LANGUAGES
from kitrobot.translation.reader_language import reader_language, translate


def readable(words: str) -> str:
    """The same as text that can be sent: a file's name may hold what is no UTF-8."""
    return words.encode(errors="surrogatepass").decode(errors="replace")


def clause(words: str) -> str:
    """A message in the reader's language. A name that it begins with is between back quotes: the page begins its
    sentences large, and `square.krt` is no `Square.krt`.
    """
    text = readable(translate(words))
    name = _first_name(text, words) if isinstance(words, Sentence) else ""
    return f"`{name}`{text[len(name) :]}" if name[:1].islower() else text


def _first_name(text: str, words: str) -> str:
    """The value with which a sentence begins: a name, a number or code; "" for none, and before a colon."""
    if isinstance(words, Sentence):
        inner = words.parts if isinstance(words, Series) else words.values.values()
        found = (_first_name(text, one) for one in inner if isinstance(one, str))
        return next((one for one in found if one), "")
    return words if words and re.match(rf"{re.escape(words)}(?![\w:])", text) else ""


def spoken(words: str) -> str:
    """A message in the reader's language as a sentence of its own: a capital letter and a full stop."""
    text = clause(words)
    return text and text[0].upper() + text[1:] + ("" if text[-1] in _ENDS else LANGUAGES[reader_language()].stop)


_ENDS = (*(language.stop for language in LANGUAGES.values()), "?", "!", "؟")

FileName = Annotated[str, PlainSerializer(readable, return_type=str)]
"""A field for the name of a file on the disk, which the page shows."""
Clause = Annotated[str, SkipValidation, PlainSerializer(clause, return_type=str)]
"""A field for people, translated into the language of the request when it is sent. It takes the message as it
is, for checking it would make a plain `str` of a `kitrobot.text.Sentence`."""
Spoken = Annotated[str, SkipValidation, PlainSerializer(spoken, return_type=str)]
"""The same as a sentence of its own."""


def not_understood(error: ValidationError) -> KitRobotError:
    """What is wrong with a request over a WebSocket: the first mistake in it."""
    first = error.errors(include_url=False, include_input=False)[0]
    where = ".".join(str(part) for part in first["loc"])
    return KitRobotError(
        Sentence("the request was not understood: {reason}{where}", first["msg"], f" ({where})" if where else ""),
        Sentence("load the page again: it may be older than the studio"),
    )
