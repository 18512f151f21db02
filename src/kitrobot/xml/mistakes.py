"""What the XML parser says, in words a person can act on."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import NamedTuple

from kitrobot.text.forms import FINISH_MERGE, UNFINISHED_MERGE, conflict_mark
from kitrobot.text.sentences import Help, Sentence

_CLOSING = re.compile(r"</\s*([^\s>]{1,40})")
_ENTITY = re.compile(r"&([^;\s]{1,40});?")
_CUT_OFF = ("no element found", "unclosed token", "unclosed CDATA section", "partial character")
OLDER_COPY = Sentence(
    "the file was not written to its end, as when the power goes; an older one may lie beside it with `~` behind its"
    " name"
)
TWICE = (Sentence("an attribute is given twice in this tag"), Sentence("keep one of the two"))
_SENTENCES = {
    "junk after document element": (
        Sentence("expected the end of the file after the first element, found more"),
        Sentence("a file holds one element; everything else goes inside it"),
    ),
    "syntax error": (Sentence("expected an XML element, found text"), Sentence("a file of ours begins with `<`")),
    "duplicate attribute": TWICE,
    "XML or text declaration not at start of entity": (
        Sentence("expected `<?xml …?>` only at the very start of the file, found it here"),
        Sentence("take away what stands before it"),
    ),
}


class Mistake(NamedTuple):
    """What to say about an error of the parser, and the offset where it really is."""

    message: Sentence
    help: Help
    start: int


def explain(said: str, text: str, offset: int, opened: Sequence[tuple[str, int]]) -> Mistake:
    """A sentence and a help line for an error of the parser.

    Args:
        said: the parser's own words.
        text: the whole file.
        offset: where in it the parser stopped.
        opened: name and line of every element that is open there, outermost first.
    """
    mark = conflict_mark(text)
    if mark is not None:
        return Mistake(UNFINISHED_MERGE, FINISH_MERGE, mark)
    start = offset
    if said == "mismatched tag" and opened:
        start = max(0, text.rfind("<", 0, offset + 1))
    return Mistake(*_words(said, text, start, opened), start)


def _words(said: str, text: str, offset: int, opened: Sequence[tuple[str, int]]) -> tuple[Sentence, Help]:
    if said in _CUT_OFF:
        return _cut_off(text, opened)
    if said in _SENTENCES:
        return _SENTENCES[said]
    if said == "mismatched tag" and opened:
        name, line = opened[-1]
        found = _CLOSING.match(text, offset)
        other = f"</{found.group(1)}>" if found else Sentence("another closing tag")
        return (
            Sentence("expected </{element}> for the <{element}> of line {line}, found {found}", name, line, other),
            Sentence("close elements in the order inside out"),
        )
    if said == "undefined entity":
        entity = _ENTITY.search(text, offset)
        name = f"&{entity.group(1)};" if entity else Sentence("an entity")
        return (
            Sentence("expected one of &lt; &gt; &amp; &quot; &apos; or &#number;, found {found}", name),
            Sentence("write the character itself"),
        )
    character = text[offset : offset + 1]
    if said.startswith("not well-formed") and character:
        if character == "\0":
            return Sentence("found the character U+{number}, which XML cannot hold", "0000"), OLDER_COPY
        if not character.isprintable() and character not in "\n\t":
            return Sentence("found the character U+{number}, which XML cannot hold", f"{ord(character):04X}"), Sentence(
                "take it away"
            )
        shown = Sentence("the end of the line") if character == "\n" else f"`{character}`"
        return (
            Sentence("expected XML, found {found} where it cannot stand", shown),
            Sentence("in text, write &lt; for `<` and &amp; for `&`; put attribute values in quotes"),
        )
    return Sentence("this is not well-formed XML: {reason}", said), Sentence(
        "every element is closed, every attribute value stands in quotes"
    )


def _cut_off(text: str, opened: Sequence[tuple[str, int]]) -> tuple[Sentence, Help]:
    if not text.strip():
        return Sentence("expected an XML element, found an empty file"), OLDER_COPY
    if not opened:
        return Sentence("expected an XML element, found the end of the file"), Sentence(
            "the file may have been cut off"
        )
    name, line = opened[-1]
    return (
        Sentence("expected </{element}> for the <{element}> of line {line}, found the end of the file", name, line),
        Sentence("the file may have been cut off; take an older copy, or close what is open"),
    )
