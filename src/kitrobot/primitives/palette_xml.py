"""Where a part stands in the palette, and what finds it there: `group`, `order` and `<word>` in the XML of parts.

Nothing here changes what a program means: parts keep the order of their file everywhere but in the palette.

Left to others: which groups there are (constructors_xml), and laying the palette out (the page).
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from kitrobot.diagnostics.model import Diagnostic, Place
from kitrobot.primitives import rules
from kitrobot.primitives.constructors import Group
from kitrobot.primitives.robot import LAST_PLACE, Robot, SearchWords
from kitrobot.text.phrases import shown
from kitrobot.text.sentences import Sentence
from kitrobot.text.suggestions import Suggestions
from kitrobot.xml.attributes import NAME, optional, whole
from kitrobot.xml.element import Element, Tag
from kitrobot.xml.texts import LANGUAGE, read_text_element

LONGEST_WORD = 30
"""Characters of a word that finds a part, at most."""

MOST_WORDS = 30
"""Words that find a part in one language, at most."""

_COMMAS = re.compile("[,،]")


class _Words(NamedTuple):
    """What one `<word>` gave."""

    language: str
    words: tuple[str, ...]


def _word(element: Element) -> _Words:
    language, text = read_text_element(element)
    words = [" ".join(word.split()) for word in _COMMAS.split(text)]
    if "" in words:
        element.report(rules.SEARCH_WORD, Sentence("expected a word to find the part by in <word>, found none"))
    for word in words:
        if len(word) > LONGEST_WORD:
            element.report(
                rules.SEARCH_WORD,
                Sentence(
                    "expected at most {longest} characters in a word, found {count}: {word}",
                    LONGEST_WORD,
                    len(word),
                    shown(word),
                ),
                None,
                Sentence("write a comma between two words"),
            )
    return _Words(language, tuple(word for word in words if word and len(word) <= LONGEST_WORD))


def search_words(element: Element) -> SearchWords:
    """The words inside an element that find it, by language; those over the limit are reported and left out."""
    found: dict[str, tuple[str, ...]] = {}
    for (language, words), around in element.found_at(_Words):
        before = found.get(language, ())
        all_words = (*before, *words)
        if len(before) <= MOST_WORDS < len(all_words):
            around.report(
                rules.SEARCH_WORD,
                Sentence("expected at most {most} words in one language, found {count}", MOST_WORDS, len(all_words)),
            )
        found[language] = all_words
    return {language: words[:MOST_WORDS] for language, words in found.items()}


def word_elements(words: SearchWords) -> Iterator[tuple[str, str]]:
    """What `<word>` holds for each language, English first."""
    for language in sorted(words):
        yield language, ", ".join(words[language])


def unknown_groups(robots: Sequence[Robot], groups: Sequence[Group]) -> Iterator[Diagnostic]:
    """Reports the parts of robots whose group no file of constructors has."""
    names = {group.name for group in groups}
    suggestions = Suggestions()
    for robot in robots:
        for part in robot.objects:
            named: list[tuple[str, Place | None]] = [(part.group, part.place)]
            named += [(method.group, method.place) for method in part.methods]
            for name, place in named:
                if name and name not in names:
                    message = Sentence(
                        "{part} of {robot} stands in the group {group}, which no constructors file has",
                        part.name,
                        robot.name,
                        shown(name),
                    )
                    yield rules.PALETTE_GROUP(message, place, help=suggestions.did_you_mean(name, names))


WORD = {
    "word": Tag(
        _word,
        {LANGUAGE: optional()},
        text=True,
        about="A word that finds the part in the palette, or several with commas between. Without xml:lang, English.",
    )
}
"""Goes among the children of what stands in the palette."""

GROUP = {"group": optional(NAME, about="The tab of the palette it stands in: the name of a group of constructors.")}

ORDER = {"order": optional(whole(1, LAST_PLACE - 1), about="Its place in its tab. Without one it comes after these.")}
