"""The words of what nobody writes in a robot's XML: `automatic.xml` beside this module, in the form of parts' XML.

Left to others: what these parts do (automatic, team_objects).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import cache
from importlib.resources import files
from typing import Any, NamedTuple, TypeVar

from kitrobot.primitives.attribute_kinds import IDENTIFIER
from kitrobot.primitives.palette_xml import WORD, search_words
from kitrobot.primitives.robot import Method, Parameter, RobotObject, SearchWords, Texts
from kitrobot.xml.attributes import needed
from kitrobot.xml.element import Element, Tag
from kitrobot.xml.reader import Reader
from kitrobot.xml.texts import TEXT, TEXTS

Named = TypeVar("Named", Method, Parameter, RobotObject)

_FILE = "automatic.xml"


def part_texts(part: str, name: str = "") -> Mapping[str, Texts]:
    """The texts (`label`, `help`, `phrase`) of a part, or of what it can do."""
    return _read()[part, name].texts


def worded(part: str, made: Named) -> Named:
    """A method, a parameter or an object with the words that the file has for it in that part."""
    either: Method | Parameter | RobotObject = made
    words = _read()[part, "" if isinstance(either, RobotObject) else either.name]
    found: dict[str, Any] = dict(words.texts)
    if isinstance(either, Method):
        found["words"] = words.search
    return replace(made, **found)


class _Words(NamedTuple):
    """The texts of something by their kind, and what finds it."""

    name: str
    texts: Mapping[str, Texts]
    search: SearchWords


def _words(element: Element) -> _Words:
    return _Words(element.matching("name"), element.texts, search_words(element))


_NAMED = {"name": needed(IDENTIFIER)}
_INSIDE = Tag(_words, _NAMED, {**TEXTS, **WORD, "phrase": TEXT})
_PART = Tag(lambda element: element, _NAMED, {**TEXTS, "method": _INSIDE, "parameter": _INSIDE})


@cache
def _read() -> Mapping[tuple[str, str], _Words]:
    """By part and by what it can do, "" for the part itself."""
    reader = Reader((files("kitrobot.primitives") / _FILE).read_bytes(), _FILE)
    root = reader.read({"parts": Tag(children={"part": _PART})})
    assert root is not None
    assert not reader.diagnostics, reader.diagnostics
    made: dict[tuple[str, str], _Words] = {}
    for part in root.found(Element):
        made[part.matching("name"), ""] = _words(part)
        for inside in part.found(_Words):
            made[part.matching("name"), inside.name] = inside
    return made
