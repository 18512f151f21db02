"""The reader's language, set for the duration of a request and for the tasks that it starts."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar

from kitrobot.translation.languages import ENGLISH, LANGUAGES
from kitrobot.translation.translator import translate_to

_reader: ContextVar[str] = ContextVar("reader", default=ENGLISH)

MOST_WISHES = 20
"""Languages of a wish that are looked at; browsers name a handful."""


def best_language(wish: str) -> str:
    """The first language of an `Accept-Language` value that there is a table for ("fr-CA" is French), else English.

    The order of the list counts, as browsers write it; weights (`;q=`) are passed over.
    """
    for wanted in wish[:1000].split(",")[:MOST_WISHES]:
        language = wanted.split(";")[0].strip().lower().split("-")[0]
        if language in LANGUAGES:
            return language
    return ENGLISH


@contextmanager
def override_language(language: str) -> Iterator[None]:
    """Says everything in that language as long as the block lasts, in tasks and threads begun in it too."""
    before = _reader.set(language)
    try:
        yield
    finally:
        _reader.reset(before)


def reader_language() -> str:
    """The reader's language."""
    return _reader.get()


def translate(sentence: str) -> str:
    """A sentence of a room in the reader's language; English where there is no translation."""
    language = _reader.get()
    return sentence if language == ENGLISH else translate_to(sentence, language)
