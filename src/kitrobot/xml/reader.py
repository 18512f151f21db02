"""Reading XML: the one way in which every file of the house (constructors, robots, missions, worlds) is read.

The parser's events go through a table of `Tag`s, which says for each element what it may hold and which function turns
it into a value; see `element`. So a reader is a table and a handful of short functions, and all of them treat bad input
alike: documents with a DTD, too deep, too large, cut off, malformed or in another encoding give exactly one error,
with its line and column, and nothing else; unknown elements, attributes and text are reported and the rest stays
usable.

What is parsed is UTF-8 with line feeds only as line breaks, as XML asks of every reader. Places are kept as offsets of
bytes into it, where the parser says that an event begins; they become lines and columns when something is reported.
Attributes are names, numbers and words: they are read in the one form of names (`kitrobot.text.name_form`).
Only an attribute's place is searched for, in its start tag, because the parser does not tell it. Left to others: what
a file means.
"""

from __future__ import annotations

import re
from collections.abc import Hashable, Mapping
from typing import NoReturn

from kitrobot.diagnostics.model import Diagnostic, Place, Source
from kitrobot.text.collection import collection_paused
from kitrobot.text.forms import name_form
from kitrobot.text.phrases import one_of, shown
from kitrobot.text.positions import BytePositions
from kitrobot.text.sentences import Sentence
from kitrobot.text.suggestions import Suggestions
from kitrobot.xml import rules
from kitrobot.xml.decoder import decode
from kitrobot.xml.element import Element, Tag
from kitrobot.xml.expat_parser import DoctypeError, ExpatError, error_text, new_parser
from kitrobot.xml.foreign import bound, declares, in_scope, is_foreign
from kitrobot.xml.mistakes import TWICE, explain

MAX_DEPTH = 64
"""Elements inside one another, at most."""

MAX_PROBLEMS = 100
"""Diagnostics kept of one file; the rest is counted."""

_WINDOW = 65_536
"""Bytes of a start tag that are searched for an attribute's place, at most."""

_ATTRIBUTE = re.compile(rb"""\s([^\s=<>"']+)\s*=\s*("[^"]*"|'[^']*')""")
_DOCTYPE = b"<!DOCTYPE"
COMMENT_END, INSTRUCTION_END = b"-->", b"?>"


class _ReadingEndError(Exception):
    """Reading cannot go on; the diagnostic is in the reader."""


class Reader:
    """Reads one XML file. `read` is called once; afterwards `diagnostics` holds everything found wrong."""

    def __init__(self, data: bytes, name: str) -> None:
        self.name = name
        self.suggestions = Suggestions()
        self.own: dict[str, set[Hashable]] = {}
        """What tells a mission's own parts apart, by the name of their element, as far as they were read."""
        self.prolog: list[str] = []
        """Comments and instructions before the first element, word for word."""
        self.epilog: list[str] = []
        """The same behind it."""
        self._data = data
        self.in_one_form = True
        """Whether no attribute can be in another form than that of names: there is ASCII alone."""
        self._positions = BytePositions(b"")
        self._problems: list[Diagnostic] = []
        self._left_out = 0

    @property
    def diagnostics(self) -> list[Diagnostic]:
        """What was found wrong, in the order in which it was found."""
        if not self._left_out:
            return list(self._problems)
        last = self._problems[-1].place
        return [
            *self._problems,
            rules.TOO_MANY(
                Sentence.counted(
                    "{count} more problems are not shown", "{count} more problems are not shown", self._left_out
                ),
                last,
            ),
        ]

    def add(self, diagnostic: Diagnostic) -> None:
        """Keeps a diagnostic."""
        if len(self._problems) < MAX_PROBLEMS:
            self._problems.append(diagnostic)
        else:
            self._left_out += 1

    def stop(self, diagnostic: Diagnostic) -> NoReturn:
        """Ends the reading with the one diagnostic that matters."""
        self._problems, self._left_out = [diagnostic], 0
        raise _ReadingEndError

    def read(self, roots: Mapping[str, Tag]) -> Element | None:
        """The file's first element, which must be one of `roots`; None when the file cannot be used at all."""
        try:
            text = decode(self._data, self.name)
            if isinstance(text, Diagnostic):
                self.stop(text)
            self._data = text.encode()
            self.in_one_form = self._data.isascii() and b"&#" not in self._data
            self._positions = BytePositions(self._data)
            events = _Events(self, roots)
            with collection_paused():
                events.parse(self._data)
        except _ReadingEndError:
            return None
        return events.root

    # -- places

    def place(self, start: int, length: int = 1) -> Place:
        """The place of so many characters on one line."""
        line, column = self._positions.position(start)
        return Place(self.name, line, column, line, column + length)

    def span(self, start: int, end: int) -> Place:
        """The place between two offsets."""
        return Place(self.name, *self._positions.position(start), *self._positions.position(end))

    def place_of(self, element: Element, attribute: str | None = None) -> Place:
        """The start of an element's start tag, or the value of one of its attributes."""
        if attribute in element.attributes and len(self._problems) < MAX_PROBLEMS:
            wanted = str(attribute)
            for found in _ATTRIBUTE.finditer(self._data, element.start, element.start + _WINDOW):
                if name_form(found.group(1).decode(errors="replace")) == wanted:
                    value = found.start(2) + 1
                    return self.span(value, max(found.end(2) - 1, value + 1))
        return self.place(element.start, len(element.name) + 1)

    def offsets_of_text(self, element: Element) -> list[int]:
        """For each character of an element's text, and its end, its offset (entities and CDATA are followed)."""
        offsets: list[int] = []
        for start, piece in zip(element.starts, element.pieces, strict=True):
            at = start
            for character in piece:
                offsets.append(at)
                at += len(character.encode())
        return [*offsets, element.end]

    def raw(self, start: int, end: int, *, holds_more: bool) -> str:
        """An element word for word, by where it starts and where its end tag begins, or where it ends: `<a/>`.

        `holds_more`: it has elements inside, so `/>` before its end tag is not its own.
        """
        if holds_more or not self._data.endswith(b"/>", start, end):
            end = self._data.index(b">", end) + 1
        return self._data[start:end].decode()

    def raw_remark(self, start: int, closing: bytes) -> str:
        """A comment or an instruction word for word, by where it starts and what it ends with."""
        end = self._data.index(closing, start + len(b"<!--" if closing == COMMENT_END else b"<?")) + len(closing)
        return self._data[start:end].decode()


class _Events:
    """The parser's events, walked through the table of tags."""

    def __init__(self, reader: Reader, roots: Mapping[str, Tag]) -> None:
        self.reader = reader
        self.roots = roots
        self.root: Element | None = None
        self.open: list[Element] = []
        self.names: list[tuple[str, int]] = []
        """Name and start of each element that is open, the unknown ones too."""
        self.skipping: int | None = None
        """How many elements are open around what is skipped, itself counted."""
        self.started = 0
        """Where the element began that was opened last."""
        self.scopes: list[Mapping[str, str]] = [{}]
        """Prefix → namespace around and in each element that is open."""
        self.parser = new_parser("utf-8")
        self.parser.CommentHandler = lambda _: self.remark(COMMENT_END)
        self.parser.ProcessingInstructionHandler = lambda *_: self.remark(INSTRUCTION_END)
        self.parser.StartElementHandler = self.start
        self.parser.EndElementHandler = self.end
        self.parser.CharacterDataHandler = self.characters

    def parse(self, data: bytes) -> None:
        try:
            self.parser.Parse(data, True)
        except ExpatError as error:
            self.reader.stop(self.mistake(error, data))
        except DoctypeError:
            at = max(0, data.rfind(_DOCTYPE, 0, self.parser.CurrentByteIndex + 1))
            self.reader.stop(
                rules.FORBIDDEN(
                    Sentence("expected no document type and no entities, found a <!DOCTYPE …>"),
                    self.reader.span(at, at + len(_DOCTYPE)),
                    help=Sentence("take the whole <!DOCTYPE …> away; write the characters themselves, or &#number;"),
                )
            )

    def mistake(self, error: ExpatError, data: bytes) -> Diagnostic:
        source = Source(self.reader.name, data.decode())
        offset = len(data[: max(0, self.parser.ErrorByteIndex)].decode())
        opened = [(name, self.reader.place(start).line) for name, start in self.names]
        found = explain(error_text(error), source.text, offset, opened)
        return rules.NOT_WELL_FORMED(found.message, source.place(found.start, found.start + 1), help=found.help)

    def start(self, name: str, attributes: dict[str, str]) -> None:
        start = self.started = self.parser.CurrentByteIndex
        self.names.append((name, start))
        if len(self.names) > MAX_DEPTH:
            self.reader.stop(
                rules.TOO_DEEP(
                    Sentence("expected at most {most} elements inside one another, found one more", MAX_DEPTH),
                    self.reader.place(start, len(name) + 1),
                )
            )
        self.scopes.append(in_scope(self.scopes[-1], attributes))
        if self.skipping is not None:
            return
        parent = self.open[-1] if self.open else None
        known = parent.tag.children if parent is not None else self.roots
        tag = known.get(name)
        if tag is None:
            self.unknown(name, parent, start)
            return
        if not self.reader.in_one_form:
            attributes = self.one_form(attributes, start, name)
        element = Element(self.reader, tag, name, attributes, parent, start)
        for attribute in [one for one in attributes if one not in tag.attributes]:
            self.attribute(element, attribute)
        self.open.append(element)
        if tag.open is not None:
            tag.open(element)

    def attribute(self, element: Element, attribute: str) -> None:
        """An attribute that the table does not know."""
        tag = element.tag
        if is_foreign(attribute) and tag.keeps_foreign:
            element.foreign[attribute] = element.attributes.pop(attribute)
        elif declares(attribute) or (attribute.startswith("xsi:") and element.parent is None):
            # What is kept inside takes its namespaces along; a file that nobody writes again loses no schema.
            del element.attributes[attribute]
        elif is_foreign(attribute) or not tag.free_attributes:
            help = element.did_you_mean(attribute, tag.attributes)
            message = Sentence(
                "<{element}> has no attribute {attribute}; it is left out", element.name, shown(attribute)
            )
            element.report(rules.UNKNOWN_ATTRIBUTE, message, attribute, help)
            if is_foreign(attribute):
                del element.attributes[attribute]

    def remark(self, closing: bytes) -> None:
        """A comment or an instruction."""
        if self.skipping is not None:
            return
        raw = self.reader.raw_remark(self.parser.CurrentByteIndex, closing)
        if self.open:
            self.hand_on(self.open[-1], raw)
        else:
            (self.reader.prolog if self.root is None else self.reader.epilog).append(raw)

    def hand_on(self, element: Element, raw: str) -> None:
        """Gives a comment or an instruction to an element that may keep it."""
        if element.tag.keep is not None:
            element.tag.keep(element, raw)
        else:
            element.remarks.append((len(element.values), raw))

    def one_form(self, attributes: dict[str, str], start: int, name: str) -> dict[str, str]:
        """The attributes, which are names mostly, in the one form of names."""
        made = {
            key if is_foreign(key) else name_form(key): value if is_foreign(key) else name_form(value)
            for key, value in attributes.items()
        }
        if len(made) < len(attributes):
            message, help = TWICE
            self.reader.stop(rules.NOT_WELL_FORMED(message, self.reader.place(start, len(name) + 1), help=help))
        return made

    def unknown(self, name: str, parent: Element | None, start: int) -> None:
        place = self.reader.place(start, len(name) + 1)
        if parent is None:
            expected = one_of(f"<{root}>" for root in self.roots)
            self.reader.stop(
                rules.WRONG_ROOT(
                    Sentence("expected {expected} as the first element, found <{found}>", expected, shown(name)[1:-1]),
                    place,
                )
            )
        fate = Sentence("left out") if parent.tag.keep is None else Sentence("kept as it is")
        message = Sentence("<{parent}> has no element <{element}>; it is {fate}", parent.name, shown(name)[1:-1], fate)
        self.reader.add(rules.UNKNOWN_ELEMENT(message, place, help=parent.did_you_mean(name, parent.tag.children)))
        self.skipping = len(self.names)

    def end(self, name: str) -> None:
        depth = len(self.names)
        _, start = self.names.pop()
        self.scopes.pop()
        if self.skipping is not None:
            if depth == self.skipping:
                self.skipping = None
                self.keep(self.open[-1], start)
            return
        element = self.open.pop()
        element.end = self.parser.CurrentByteIndex
        value = element.tag.close(element) if element.tag.close is not None else None
        if element.parent is None:
            self.root = element
        if value is None and element.faulty and element.tag.kept_whole and element.parent is not None:
            self.keep(element.parent, start)
            return
        if element.parent is not None:
            for _, raw in element.remarks:
                self.hand_on(element.parent, raw)
        if value is not None:
            (element.parent or element).values.append((value, element))

    def keep(self, parent: Element, start: int) -> None:
        """Gives the element that ends here, word for word, to the `keep` of the one around it."""
        if parent.tag.keep is not None:
            end = self.parser.CurrentByteIndex
            raw = self.reader.raw(start, end, holds_more=start != self.started)
            parent.tag.keep(parent, bound(raw, self.scopes[-1]))

    def characters(self, content: str) -> None:
        if self.skipping is not None or not self.open:
            return
        element = self.open[-1]
        if element.tag.text:
            element.pieces.append(content)
            element.starts.append(self.parser.CurrentByteIndex)
        elif not content.isspace() and not element.pieces:
            element.pieces.append(content)
            message = Sentence(
                "<{element}> holds no text of its own, found {found}; it is left out", element.name, shown(content)
            )
            before = content[: len(content) - len(content.lstrip())]
            start = self.parser.CurrentByteIndex + len(before.encode())
            element.add(rules.STRAY_TEXT(message, self.reader.place(start, len(content.strip()))))
