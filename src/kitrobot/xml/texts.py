"""Texts for people, once for each language: `<label>`, `<help>` and other texts of a file.

A language that the page and the command line do not support is a warning, since its text would never be shown.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from kitrobot.text.phrases import one_of, shown
from kitrobot.text.sentences import Sentence
from kitrobot.translation.languages import ENGLISH, LANGUAGES
from kitrobot.xml import rules
from kitrobot.xml.attributes import optional
from kitrobot.xml.element import Element, Tag

LANGUAGE = "xml:lang"


def read_text_element(element: Element) -> tuple[str, str]:
    """The language ("" for English) and the words of a text. Reports a language that is not spoken here, and a text
    that is longer than the `longest` of its tag.
    """
    language = element.optional(LANGUAGE, ENGLISH).lower()
    if language not in LANGUAGES:
        message = Sentence(
            "expected {expected} in {attribute}, found {found}: nobody is shown this text",
            one_of(LANGUAGES),
            LANGUAGE,
            shown(language),
        )
        element.report(rules.UNKNOWN_LANGUAGE, message, LANGUAGE)
    words, longest = element.words, element.tag.longest
    if longest and len(words) > longest:
        message = Sentence(
            "expected at most {longest} characters in <{element}>, found {count}", longest, element.name, len(words)
        )
        element.report(rules.LONG_TEXT, message, None, Sentence("say it in fewer words"))
    return "" if language == ENGLISH else language, words


def report_duplicate_text(element: Element) -> None:
    """Reports that there is such a text in this language already."""
    element.report(rules.DUPLICATE, Sentence("there is a <{element}> in this language already", element.name))


def _keep_text(element: Element) -> None:
    assert element.parent is not None
    language, words = read_text_element(element)
    texts = element.parent.texts.setdefault(element.name, {})
    if language in texts:
        report_duplicate_text(element)
    texts.setdefault(language, words)


TEXT = Tag(
    close=_keep_text,
    attributes={LANGUAGE: optional()},
    text=True,
    about="A text for people. Without xml:lang it is English; give it once for each language.",
    type_name="text",
)
"""A text for people, once for each language: ends up in `texts` of the element around it."""

TEXTS: Mapping[str, Tag] = {
    "help": replace(TEXT, about="One or two sentences that a twelve-year-old understands."),
    "label": replace(TEXT, about="The word shown instead of the name."),
}
"""What everything that people see may have."""
