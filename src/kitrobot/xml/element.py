"""One XML element while it is read: its attributes, its text, what was found inside, and its place in the file.

A reader's `Tag` table says what an element may hold; `close` of a tag turns the finished element into a value, which
is kept in `values` of the element around it. Attributes are asked for by kind (`integer`, `choice`, …); each asking
reports what is wrong with the value and gives one that can be used, so a handler needs no error handling of its own.
Whoever must know asks `faulty`: true when the element or anything inside it has an error.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, TypeVar

from kitrobot.diagnostics.model import Diagnostic, Place, Rule
from kitrobot.text.phrases import one_of, shown
from kitrobot.text.sentences import Help, Sentence, Word
from kitrobot.xml import rules
from kitrobot.xml.attributes import Attribute

if TYPE_CHECKING:
    from kitrobot.xml.reader import Reader

T = TypeVar("T")

_INTEGER = re.compile(r"[+-]?[0-9]{1,18}")
_DECIMAL = re.compile(r"[+-]?(?:[0-9]{1,18}(?:\.[0-9]{0,18})?|\.[0-9]{1,18})(?:[eE][+-]?[0-9]{1,3})?")
LONGEST_NAME = 100
"""Characters of a name, at most."""


@dataclass(frozen=True, slots=True)
class Tag:
    """What one kind of element may hold, and what becomes of it.

    `open` is called at the start tag, with all attributes; `close` at the end tag, and its result (unless None) is
    added to the `values` of the element around. With `free_attributes` any attribute without a prefix is allowed.
    `keep` is given each unknown element word for word; without it they are left out. An element with `kept_whole` that
    has an error is given to the `keep` of the element around it in the same way. Comments and instructions go to the
    nearest `keep` around them, unless `close` took them (`Element.take_remarks`). With `keeps_foreign`, attributes with
    a prefix are in `Element.foreign`; without it they are left out.

    A text is at most `longest` characters long, spaces in a row counted as one; 0: as long as the file.

    For the schema only: at least how many elements are inside, paths of elements inside whose names differ, a
    sentence about the element, and the name of its type where several elements share it.
    """

    close: Callable[[Element], object] | None = None
    attributes: Mapping[str, Attribute] = field(default_factory=dict)
    children: Mapping[str, Tag] = field(default_factory=dict)
    text: bool = False
    free_attributes: bool = False
    open: Callable[[Element], object] | None = None
    keep: Callable[[Element, str], None] | None = None
    kept_whole: bool = False
    keeps_foreign: bool = False
    least: int = 0
    unique: tuple[str, ...] = ()
    longest: int = 0
    about: str = ""
    type_name: str = ""


class Element:
    """An element between its start tag and the end of its parent."""

    __slots__ = (
        "attributes",
        "end",
        "faulty",
        "foreign",
        "name",
        "parent",
        "pieces",
        "reader",
        "remarks",
        "start",
        "starts",
        "tag",
        "texts",
        "values",
    )

    def __init__(
        self,
        reader: Reader,
        tag: Tag,
        name: str,
        attributes: dict[str, str],
        parent: Element | None,
        start: int,
    ) -> None:
        self.reader = reader
        self.tag = tag
        self.name = name
        self.attributes = attributes
        self.parent = parent
        self.start = start
        """Where the start tag begins: an offset of bytes, as are all here (see `Reader`)."""
        self.end = start
        """Where the end tag begins, or an empty element ends."""
        self.pieces: list[str] = []
        self.starts: list[int] = []
        """Where each of the pieces of text begins."""
        self.values: list[tuple[object, Element]] = []
        self.texts: dict[str, dict[str, str]] = {}
        self.faulty = False
        self.foreign: dict[str, str] = {}
        """Attributes with a prefix and declarations of namespaces, where its tag keeps them."""
        self.remarks: list[tuple[int, str]] = []
        """Comments and instructions inside, each with how many values there were before it."""

    # -- what is inside

    def take_remarks(self) -> list[tuple[int, str]]:
        """The comments and instructions inside, which nobody else gets then; see `remarks`."""
        taken, self.remarks = self.remarks, []
        return taken

    @property
    def text(self) -> str:
        """The text as it stands, spaces and line breaks included."""
        return "".join(self.pieces)

    @property
    def words(self) -> str:
        """The text with every run of white space as one space."""
        return " ".join(self.text.split())

    def found(self, kind: type[T]) -> list[T]:
        """The values of one type that the elements inside gave, in order."""
        return [value for value, _ in self.values if isinstance(value, kind)]

    def found_at(self, kind: type[T]) -> list[tuple[T, Element]]:
        """As `found`, each with the element that gave it."""
        return [(value, element) for value, element in self.values if isinstance(value, kind)]

    def distinct(self, kind: type[T], key: Callable[[T], str], what: str) -> list[T]:
        """As `found`, without those whose key came before; these are reported."""
        first: dict[str, T] = {}
        for value, element in self.found_at(kind):
            if key(value) in first:
                element.report(
                    rules.DUPLICATE,
                    Sentence("the {category} {part} is there already", Word(what), shown(key(value))),
                    "name",
                )
            else:
                first[key(value)] = value
        return list(first.values())

    # -- attributes

    def optional(self, name: str, default: str = "") -> str:
        """The attribute as it stands, or the default."""
        return self.attributes.get(name, default)

    def required(self, name: str) -> str:
        """The attribute as it stands; "" when it is missing or empty, which is reported."""
        value = self.attributes.get(name, "")
        if not value:
            self.report(
                rules.MISSING,
                Sentence('expected {attribute}="…" on <{element}>, found none', name, self.name),
                name if name in self.attributes else None,
            )
        return value

    def matching(self, name: str, default: str | None = None) -> str:
        """The attribute when it fits its kind. Without a default it is required."""
        if default is not None and name not in self.attributes:
            return default
        value, kind = self.required(name), self._attribute(name).kind
        if len(value) > LONGEST_NAME:
            self.bad_value(name, Sentence("at most {longest} characters", LONGEST_NAME))
            return default or ""
        if value and kind.fits is not None and not kind.fits(value):
            self.bad_value(name, kind.words)
            return default or ""
        return value

    def choice(self, name: str, default: str | None = None) -> str:
        """The attribute when it is one of the options of its kind; else the default, or the first option."""
        attribute = self._attribute(name)
        allowed = attribute.kind.options
        if default is None:
            default = attribute.default
        if default is not None and name not in self.attributes:
            return default
        value = self.required(name)
        if value in allowed:
            return value
        if value:
            self.bad_value(name, one_of(allowed), self.did_you_mean(value, allowed))
        return default if default is not None else allowed[0]

    def flag(self, name: str) -> bool:
        """The attribute as yes or no."""
        return self.choice(name, "no") == "yes"

    def integer(self, name: str, default: int | None = None) -> int:
        """The attribute as a whole number of its kind; without a default, here or in the table, it is required."""
        attribute = self._attribute(name)
        if default is None and attribute.default is not None:
            default = int(attribute.default)
        return self.between(name, int(attribute.kind.least), int(attribute.kind.most), default)

    def between(self, name: str, least: int, most: int, default: int | None = None) -> int:
        """The attribute as a whole number `least`…`most`; without a default it is required."""
        if default is not None and name not in self.attributes:
            return default
        text = self.required(name).strip()
        if _INTEGER.fullmatch(text) and least <= int(text) <= most:
            return int(text)
        if text:
            self.bad_value(name, Sentence("a whole number from {least} to {most}", least, most))
        return default if default is not None else max(least, min(0, most))

    def decimal(self, name: str) -> float:
        """The attribute as a number of its kind, with or without a decimal point."""
        attribute = self._attribute(name)
        least, most = attribute.kind.least, attribute.kind.most
        default = None if attribute.default is None else float(attribute.default)
        if default is not None and name not in self.attributes:
            return default
        text = self.required(name).strip()
        if _DECIMAL.fullmatch(text) and math.isfinite(value := float(text)) and least <= value <= most:
            return value
        if text:
            self.bad_value(name, Sentence("a number from {least} to {most}", f"{least:g}", f"{most:g}"))
        return default if default is not None else max(least, min(0.0, most))

    def version(self, newest: int) -> int:
        """The format's version; reading ends here when the file is newer than this program."""
        found = self.between("version", 1, 10**9, 1) if "version" in self.attributes else 1
        if "version" not in self.attributes:
            self.report(
                rules.MISSING, Sentence('expected version="{newest}" on <{element}>, found none', newest, self.name)
            )
        if found > newest:
            self.reader.stop(
                rules.NEWER_VERSION(
                    Sentence("expected version {newest} or older, found version {found}", newest, found),
                    self.place("version"),
                    help=Sentence("open it with a newer KitRobot"),
                )
            )
        return found

    def _attribute(self, name: str) -> Attribute:
        return self.tag.attributes[name]

    # -- saying what is wrong

    def place(self, attribute: str | None = None) -> Place:
        """Where the element's start tag stands, or the value of one of its attributes."""
        return self.reader.place_of(self, attribute)

    def report(self, rule: Rule, message: Sentence, attribute: str | None = None, help: Help = "") -> None:
        """Adds a diagnostic about this element, at the attribute when it is given and there."""
        self.add(rule(message, self.place(attribute), help=help))

    def add(self, diagnostic: Diagnostic) -> None:
        """Adds a diagnostic made elsewhere; an error makes this element and all around it faulty."""
        self.reader.add(diagnostic)
        if diagnostic.is_error:
            element: Element | None = self
            while element is not None:
                element.faulty = True
                element = element.parent

    def did_you_mean(self, word: str, words: Iterable[str]) -> Help:
        """`did you mean X?` for a help line, or ""; of very many misspelt words in a file only for the first ones."""
        return self.reader.suggestions.did_you_mean(word, words)

    def bad_value(self, name: str, expected: str, help: Help = "") -> None:
        """Reports an attribute's value: what was expected, and what was found."""
        self.report(
            rules.BAD_VALUE,
            Sentence("expected {expected} in {attribute}, found {found}", expected, name, shown(self.attributes[name])),
            name,
            help,
        )
