"""Reading XML: the one way in which every file of the house (constructors, robots, missions, worlds) is read.

SAX events go through a table of `Tag`s, which says for each element what it may hold and which function turns it into a
value; see `xml_element`. So a reader is a table and a handful of short functions, and all of them treat bad input
alike: documents with a DTD, too deep, too large, cut off, malformed or in another encoding give exactly one error,
with its line and column, and nothing else; unknown elements, attributes and text are reported and the rest stays
usable.

The text that is parsed has line feeds only as line breaks, as XML asks of every reader, so the lines and columns of the
parser are those of the text. Left to others: what a file means.
"""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Hashable, Mapping
from itertools import accumulate
from typing import NoReturn
from xml.sax import SAXParseException
from xml.sax.handler import ContentHandler
from xml.sax.xmlreader import AttributesImpl

from defusedxml.common import DefusedXmlException
from defusedxml.sax import make_parser

from kitrobot.diagnostics import Diagnostic, Place
from kitrobot.lll import collection_paused
from kitrobot.primitives import rules
from kitrobot.primitives.suggestions import Suggestions
from kitrobot.primitives.xml_decoding import decode
from kitrobot.primitives.xml_element import Element, Tag, one_of, shown
from kitrobot.primitives.xml_mistakes import explain

MAX_DEPTH = 64
"""Elements inside one another, at most."""

MAX_PROBLEMS = 100
"""Diagnostics kept of one file; the rest is counted."""

_WINDOW = 65_536
"""Characters of a start tag that are searched for an attribute's place, at most."""

_ATTRIBUTE = re.compile(r"""\s([^\s=<>"']+)\s*=\s*("[^"]*"|'[^']*')""")
_START_TAG = re.compile(r"""<[^>"']*(?:"[^"]*"[^>"']*|'[^']*'[^>"']*)*>""")
_TEXT_PIECE = re.compile(r"<!--.*?-->|<\?.*?\?>|<!\[CDATA\[(?P<data>.*?)\]\]>|&[^;]*;|[^<&]", re.DOTALL)


class _Stop(Exception):
    """Reading cannot go on; the diagnostic is in the reader."""


class Reader:
    """Reads one XML file. `read` is called once; afterwards `diagnostics` holds everything found wrong."""

    def __init__(self, data: bytes, name: str) -> None:
        self.name = name
        self.text = ""
        self.suggestions = Suggestions()
        self.own: dict[str, set[Hashable]] = {}
        """What tells a mission's own parts apart, by the name of their element, as far as they were read."""
        self._data = data
        self._problems: list[Diagnostic] = []
        self._left_out = 0
        self._lines: list[int] = []

    @property
    def diagnostics(self) -> list[Diagnostic]:
        """What was found wrong, in the order in which it was found."""
        if not self._left_out:
            return list(self._problems)
        last = self._problems[-1].place
        return [*self._problems, rules.TOO_MANY(f"{self._left_out} more problems are not shown", last)]

    def add(self, diagnostic: Diagnostic) -> None:
        """Keeps a diagnostic."""
        if len(self._problems) < MAX_PROBLEMS:
            self._problems.append(diagnostic)
        else:
            self._left_out += 1

    def stop(self, diagnostic: Diagnostic) -> NoReturn:
        """Ends the reading with the one diagnostic that matters."""
        self._problems, self._left_out = [diagnostic], 0
        raise _Stop

    def read(self, roots: Mapping[str, Tag]) -> Element | None:
        """The file's first element, which must be one of `roots`; None when the file cannot be used at all."""
        try:
            text = decode(self._data, self.name)
            if isinstance(text, Diagnostic):
                self.stop(text)
            self.text = text
            events = _Events(self, roots)
            with collection_paused():
                events.parse(self.text)
        except _Stop:
            return None
        return events.root

    # -- places

    def place(self, line: int, column: int, length: int = 1) -> Place:
        """A place on one line of the file."""
        return Place(self.name, line, column, line, column + length)

    def place_of(self, element: Element, attribute: str | None = None) -> Place:
        """The start of an element's start tag, or the value of one of its attributes."""
        if attribute in element.attributes and len(self._problems) < MAX_PROBLEMS:
            start = self.offset(element.line, element.column)
            for found in _ATTRIBUTE.finditer(self.text, start, start + _WINDOW):
                if found.group(1) == attribute:
                    value = found.start(2) + 1
                    return self.span(value, max(found.end(2) - 1, value + 1))
        return self.place(element.line, element.column, len(element.name) + 1)

    def span(self, start: int, end: int) -> Place:
        """The place between two offsets of `text`."""
        return Place(self.name, *self._position(start), *self._position(end))

    def offsets_of_text(self, element: Element) -> list[int]:
        """For each character of an element's text, and its end, the offset in `text` (entities and CDATA are followed).

        What follows an element inside, which is reported as unknown, is said to stand where that one begins.
        """
        at = self.offset(element.line, element.column)
        at += len(self._start_tag(at))
        offsets: list[int] = []
        while piece := _TEXT_PIECE.match(self.text, at):
            if piece.group("data") is not None:
                offsets += range(piece.start("data"), piece.end("data"))
            elif not piece.group().startswith(("<!", "<?")):
                offsets.append(at)
            at = piece.end()
        return [*offsets, *[at] * max(1, len(element.text) + 1 - len(offsets))]

    def _start_tag(self, start: int) -> str:
        match = _START_TAG.match(self.text, start)
        return match.group() if match else ""

    def raw(self, start_line: int, start_column: int, end_line: int, end_column: int) -> str:
        """An element word for word, from the parser's positions of its start and its end."""
        start = self.offset(start_line, start_column)
        tag = self._start_tag(start)
        if tag.endswith("/>"):
            return tag
        return self.text[start : self.text.index(">", self.offset(end_line, end_column)) + 1]

    def offset(self, line: int, column: int) -> int:
        """The offset in `text` of a line and a column."""
        if not self._lines:
            self._lines = [0, *accumulate(len(part) + 1 for part in self.text.split("\n"))]
        return self._lines[line - 1] + column - 1

    def _position(self, offset: int) -> tuple[int, int]:
        if not self._lines:
            self.offset(1, 1)
        line = bisect_right(self._lines, offset)
        return line, offset - self._lines[line - 1] + 1


class _Events(ContentHandler):
    """The parser's events, walked through the table of tags."""

    def __init__(self, reader: Reader, roots: Mapping[str, Tag]) -> None:
        super().__init__()
        self.reader = reader
        self.roots = roots
        self.root: Element | None = None
        self.open: list[Element] = []
        self.names: list[tuple[str, int]] = []
        self.skipping: tuple[int, int, int] | None = None
        self.parser = make_parser()

    def parse(self, text: str) -> None:
        parser = self.parser
        parser.forbid_dtd = True
        parser.setContentHandler(self)
        try:
            parser.feed(text)
            parser.close()
        except SAXParseException as error:
            offset = self.reader.offset(error.getLineNumber() or 1, (error.getColumnNumber() or 0) + 1)
            mistake = explain(error.getMessage(), text, offset, self.names)
            place = self.reader.span(mistake.start, mistake.start + 1)
            self.reader.stop(rules.NOT_WELL_FORMED(mistake.message, place, help=mistake.help))
        except DefusedXmlException:
            at = text.rfind("<!DOCTYPE", 0, self.reader.offset(*self.position()) + 1)
            self.reader.stop(
                rules.FORBIDDEN(
                    "expected no document type and no entities, found a <!DOCTYPE …>",
                    self.reader.span(max(0, at), max(0, at) + len("<!DOCTYPE")),
                    help="take the whole <!DOCTYPE …> away; write the characters themselves, or &#number;",
                )
            )

    def position(self) -> tuple[int, int]:
        return self.parser.getLineNumber() or 1, (self.parser.getColumnNumber() or 0) + 1

    def startElement(self, name: str, attrs: AttributesImpl) -> None:
        line, column = self.position()
        self.names.append((name, line))
        if len(self.names) > MAX_DEPTH:
            self.reader.stop(
                rules.TOO_DEEP(
                    f"expected at most {MAX_DEPTH} elements inside one another, found one more",
                    self.reader.place(line, column, len(name) + 1),
                )
            )
        if self.skipping is not None:
            return
        parent = self.open[-1] if self.open else None
        known = parent.tag.children if parent is not None else self.roots
        tag = known.get(name)
        if tag is None:
            self.unknown(name, parent, line, column)
            return
        element = Element(self.reader, tag, name, dict(attrs.items()), parent, line, column)
        if not tag.free_attributes:
            for attribute in element.attributes:
                if attribute not in tag.attributes and not attribute.startswith(("xmlns", "xsi:")):
                    help = element.did_you_mean(attribute, tag.attributes)
                    message = f"<{name}> has no attribute {shown(attribute)}; it is left out"
                    element.report(rules.UNKNOWN_ATTRIBUTE, message, attribute, help)
        self.open.append(element)
        if tag.open is not None:
            tag.open(element)

    def unknown(self, name: str, parent: Element | None, line: int, column: int) -> None:
        place = self.reader.place(line, column, len(name) + 1)
        if parent is None:
            expected = one_of(f"<{root}>" for root in self.roots)
            self.reader.stop(
                rules.WRONG_ROOT(f"expected {expected} as the first element, found <{shown(name)[1:-1]}>", place)
            )
        fate = "left out" if parent.tag.keep is None else "kept as it is"
        message = f"<{parent.name}> has no element <{shown(name)[1:-1]}>; it is {fate}"
        self.reader.add(rules.UNKNOWN_ELEMENT(message, place, help=parent.did_you_mean(name, parent.tag.children)))
        self.skipping = (len(self.names), line, column)

    def endElement(self, name: str) -> None:
        if self.skipping is not None:
            depth, line, column = self.skipping
            if depth == len(self.names):
                self.skipping = None
                keeper = self.open[-1]
                if keeper.tag.keep is not None:
                    keeper.tag.keep(keeper, self.reader.raw(line, column, *self.position()))
            self.names.pop()
            return
        self.names.pop()
        element = self.open.pop()
        value = element.tag.close(element) if element.tag.close is not None else None
        if element.parent is None:
            self.root = element
        if value is not None:
            (element.parent or element).values.append((value, element))
        elif element.faulty and element.tag.kept_whole:
            parent = element.parent
            if parent is not None and parent.tag.keep is not None:
                parent.tag.keep(parent, self.reader.raw(element.line, element.column, *self.position()))

    def characters(self, content: str) -> None:
        if self.skipping is not None or not self.open:
            return
        element = self.open[-1]
        if element.tag.text:
            element.pieces.append(content)
        elif not content.isspace() and not element.pieces:
            element.pieces.append(content)
            message = f"<{element.name}> holds no text of its own, found {shown(content)}; it is left out"
            line, column = self.position()
            column += len(content) - len(content.lstrip())
            element.add(rules.STRAY_TEXT(message, self.reader.place(line, column, len(content.strip()))))


def _keep_text(element: Element) -> None:
    assert element.parent is not None
    language = element.optional("xml:lang").lower()
    texts = element.parent.texts.setdefault(element.name, {})
    key = "" if language == "en" else language
    if key in texts:
        element.report(rules.DUPLICATE, f"there is a <{element.name}> in this language already")
    texts.setdefault(key, element.words)


TEXT = Tag(close=_keep_text, attributes=("xml:lang",), text=True)
"""A text for people, once for each language: ends up in `texts` of the element around it."""

TEXTS: Mapping[str, Tag] = {"help": TEXT, "label": TEXT}
"""What everything that people see may have."""
