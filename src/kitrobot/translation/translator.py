"""A sentence in another language: the translation of its template, with its values.

Values that are sentences are translated too. Other values are names, numbers or code and stay as they are, except that
between back quotes the names of parts are translated, as the canvas shows them, and that numbers are written as the
language writes them. In a language that runs from right to left, what stays English is set apart (U+2068 … U+2069), so
that the name in the middle of a sentence does not turn its surroundings about.
"""

from __future__ import annotations

import re

from kitrobot.text.sentences import HOLE, Label, Recorded, Sentence, Series, Word
from kitrobot.translation.catalogue import Catalogue, catalogue
from kitrobot.translation.languages import ENGLISH, LANGUAGES
from kitrobot.translation.recorded import recalled

DEEPEST = 20
"""Sentences in sentences that are translated; deeper ones stay English."""

_NUMBER = re.compile(r"-?[0-9]+(\.[0-9]+)?")


def translate_to(text: str, language: str) -> str:
    """The sentence in that language; a text without a template, and one without a translation, as it is."""
    if language not in LANGUAGES or language == ENGLISH or not isinstance(text, Sentence):
        return text
    return _sentence(text, language, DEEPEST) or str(text)


def _sentence(sentence: Sentence, language: str, depth: int) -> str | None:
    """The translation; None where there is none."""
    known = catalogue(language)
    if depth == 0:
        return None
    if isinstance(sentence, Word):
        return _word(sentence, known)
    if isinstance(sentence, Label):
        return sentence.texts.get(language)
    template = known.template(sentence)
    if isinstance(sentence, Series):
        sign = sentence.template if template is None else template
        return sign.join(_value(part, language, depth) for part in sentence.parts)
    if template is None:
        again = recalled(sentence, known) if isinstance(sentence, Recorded) and not sentence.values else None
        return None if again is None else _sentence(again, language, depth - 1)
    quoted = False
    made: list[str] = []
    for index, piece in enumerate(HOLE.split(template)):
        if index % 2 == 0:
            made.append(piece)
            quoted ^= bool(piece.count("`") % 2)
        elif piece not in sentence.values:
            made.append(f"{{{piece}}}")
        elif quoted:
            value = sentence.values[piece]
            label = _sentence(value, language, depth - 1) if isinstance(value, Label) else None
            made.append(label or known.word("part", str(value)) or str(value))
        else:
            made.append(_value(sentence.values[piece], language, depth))
    return "".join(made)


def _word(word: Word, known: Catalogue) -> str | None:
    """A word's translation, large or small at its beginning as the word is."""
    for context in ("part", Word.context, Sentence.context):
        found = known.word(context, word)
        if found is not None:
            return found
    small = known.word(Word.context, word[:1].lower() + word[1:])
    return None if small is None else small[:1].upper() + small[1:]


def _value(value: object, language: str, depth: int) -> str:
    """What stands in a hole."""
    if isinstance(value, Sentence):
        found = _sentence(value, language, depth - 1)
        if found is not None:
            return found
    text = str(value)
    if len(text) > 2 and text[0] == text[-1] == "`" and "`" not in text[1:-1]:
        return f"`{catalogue(language).word('part', text[1:-1]) or text[1:-1]}`"
    if _NUMBER.fullmatch(text):
        return text.replace(".", LANGUAGES[language].decimal)
    return text if not text or LANGUAGES[language].direction == "ltr" else f"\u2068{text}\u2069"
