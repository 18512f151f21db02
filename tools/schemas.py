"""Write the XML Schemas in `kitrobot/primitives/schemas`, for XML editors: they say what the tables of tags say.

python tools/schemas.py            write them
python tools/schemas.py --check    only say which are not current; status 1 if there is one

A schema has elements in any order and number, attributes with their kinds, and what must be there. What a reader finds
out by comparing several values (a minimum above a maximum, exactly one of two attributes) is in no schema. Each is
complete by itself, but for `xml.xsd`, which declares `xml:lang` and is written by hand.
"""

from __future__ import annotations

import math
import sys
from collections import Counter
from collections.abc import Iterator, Mapping
from pathlib import Path

from kitrobot.boards.bench_notes import BENCH
from kitrobot.exercise.exercise_xml import EXERCISE
from kitrobot.mission.reader import MISSION
from kitrobot.primitives.constructors_xml import CONSTRUCTORS
from kitrobot.primitives.kit_xml import KIT
from kitrobot.primitives.robot_xml import ROBOT
from kitrobot.tutorial.tutorial_xml import TUTORIAL
from kitrobot.workspace.example_list import EXAMPLES
from kitrobot.workspace.new_mission_choices import BEGINNINGS
from kitrobot.world.xml_reader import WORLD
from kitrobot.xml.attributes import TEXT_VALUE, Attribute, Kind
from kitrobot.xml.element import Tag
from kitrobot.xml.texts import LANGUAGE
from kitrobot.xml.writer import attributes, escape_text

FOLDER = Path(__file__).resolve().parents[1] / "src" / "kitrobot" / "primitives" / "schemas"
TABLES = {
    "beginnings": BEGINNINGS,
    "bench": BENCH,
    "board": KIT,
    "constructors": CONSTRUCTORS,
    "examples": EXAMPLES,
    "exercise": EXERCISE,
    "mission": MISSION,
    "robot": ROBOT,
    "tutorial": TUTORIAL,
    "world": WORLD,
}
_SOURCE = "Made by tools/schemas.py from the tables that read these files."
_HEAD = '<?xml version="1.0" encoding="UTF-8"?>'
_SCHEMA = '<xs:schema xmlns:xs="http://www.w3.org/2001/XMLSchema">'
_LANGUAGE = '<xs:import namespace="http://www.w3.org/XML/1998/namespace" schemaLocation="xml.xsd"/>'
_MANY = "unbounded"
_TypeKey = tuple[int, int, bool, bool, int, int]


def schemas() -> dict[str, str]:
    """File name → text of every schema there has to be."""
    return {f"{name}.xsd": _Schema(table).text() for name, table in TABLES.items()}


def stale() -> list[str]:
    """The files that say something else than the tables, or are missing."""
    return [
        name
        for name, text in schemas().items()
        if not (FOLDER / name).is_file() or (FOLDER / name).read_text(encoding="utf-8") != text
    ]


def main() -> int:
    wrong = stale()
    for name in wrong:
        if "--check" not in sys.argv:
            (FOLDER / name).write_text(schemas()[name], encoding="utf-8", newline="\n")
        print(name, "is not current" if "--check" in sys.argv else "written")
    return int(bool(wrong) and "--check" in sys.argv)


class _Schema:
    """Types that several elements or attributes share have names; all others stand where they are used."""

    def __init__(self, roots: Mapping[str, Tag]) -> None:
        self.roots = roots
        self.uses: Counter[_TypeKey] = Counter()
        self.elements: dict[_TypeKey, tuple[str, Tag]] = {}
        self.kinds: dict[str, Kind] = {}
        self.lengths: set[int] = set()
        for name, tag in roots.items():
            self.collect(name, tag)

    def collect(self, name: str, tag: Tag) -> None:
        key = _key(tag)
        self.uses[key] += 1
        if self.uses[key] > 1:
            return
        self.elements[key] = (tag.type_name or name, tag)
        if tag.longest:
            self.lengths.add(tag.longest)
        for attribute in tag.attributes.values():
            for kind in (attribute.kind, *attribute.kind.either):
                if kind.name:
                    self.kinds.setdefault(kind.name, kind)
        for child, inner in tag.children.items():
            self.collect(child, inner)

    def text(self) -> str:
        lines = [_HEAD, *(f"<!-- {tag.about} -->" for tag in self.roots.values()), f"<!-- {_SOURCE} -->", _SCHEMA]
        body = [_LANGUAGE]
        for name, tag in self.roots.items():
            body += self.element(name, tag, top=True)
        for key, (name, tag) in self.elements.items():
            if self.is_named(key, tag):
                body += _inside(f"<xs:complexType{attributes(('name', name))}>", self.content(tag), "</xs:complexType>")
        for kind in self.kinds.values():
            body += _simple(kind, kind.name)
        for longest in sorted(self.lengths):
            limit = ['<xs:restriction base="xs:token">', f'  <xs:maxLength value="{longest}"/>', "</xs:restriction>"]
            body += _inside(f'<xs:simpleType name="text-{longest}">', limit, "</xs:simpleType>")
        return "\n".join([*lines, *_deeper(body), "</xs:schema>"]) + "\n"

    def is_named(self, key: _TypeKey, tag: Tag) -> bool:
        return self.uses[key] > 1 and not _is_plain(tag)

    def element(self, name: str, tag: Tag, *, top: bool = False) -> Iterator[str]:
        key, kind = _key(tag), None
        if _is_plain(tag):
            kind = "xs:string"
        elif self.is_named(key, tag):
            kind = self.elements[key][0]
        head = f"<xs:element{attributes(('name', name), ('type', kind))}"
        inside = [] if top else _about(tag.about)
        if kind is None:
            inside += _inside("<xs:complexType>", self.content(tag), "</xs:complexType>")
        for path in tag.unique:
            last = path.rpartition("/")[2]
            fields = [f"<xs:selector{attributes(('xpath', path))}/>", '<xs:field xpath="@name"/>']
            inside += _inside(f"<xs:unique{attributes(('name', f'{last}-names'))}>", fields, "</xs:unique>")
        yield from _element(head, inside, "xs:element")

    def content(self, tag: Tag) -> list[str]:
        given = [line for name, one in tag.attributes.items() for line in _attribute(name, one)]
        if tag.free_attributes:
            given.append('<xs:anyAttribute namespace="##local" processContents="skip"/>')
        if tag.text:
            base = f"text-{tag.longest}" if tag.longest else "xs:string"
            extension = _inside(f"<xs:extension{attributes(('base', base))}>", given, "</xs:extension>")
            return _inside("<xs:simpleContent>", extension, "</xs:simpleContent>")
        children = [line for name, inner in tag.children.items() for line in self.element(name, inner)]
        if not children:
            return given
        head = f"<xs:choice{attributes(('minOccurs', tag.least), ('maxOccurs', _MANY))}>"
        return [*_inside(head, children, "</xs:choice>"), *given]


def _key(tag: Tag) -> _TypeKey:
    """Equal for tags that hold the very same, whatever becomes of it."""
    return id(tag.attributes), id(tag.children), tag.text, tag.free_attributes, tag.least, tag.longest


def _is_plain(tag: Tag) -> bool:
    return tag.text and not tag.attributes and not tag.free_attributes


def _attribute(name: str, attribute: Attribute) -> Iterator[str]:
    if name == LANGUAGE:
        yield f"<xs:attribute{attributes(('ref', name))}/>"
        return
    kind = attribute.kind
    named = "xs:string" if kind == TEXT_VALUE else kind.name or None
    use = "required" if attribute.needed else None
    head = attributes(("name", name), ("type", named), ("use", use), ("default", attribute.default))
    inside = [*_about(attribute.about), *([] if named else _simple(kind))]
    yield from _element(f"<xs:attribute{head}", inside, "xs:attribute")


def _simple(kind: Kind, name: str | None = None) -> list[str]:
    head = f"<xs:simpleType{attributes(('name', name))}>"
    if kind.either:
        members = " ".join(one.name for one in kind.either if one.name)
        unnamed = [line for one in kind.either if not one.name for line in _simple(one)]
        body = list(_element(f"<xs:union{attributes(('memberTypes', members or None))}", unnamed, "xs:union"))
    else:
        base = f"<xs:restriction{attributes(('base', f'xs:{kind.base}'))}"
        body = list(_element(base, list(_facets(kind)), "xs:restriction"))
    return _inside(head, [*_about(kind.about), *body], "</xs:simpleType>")


def _facets(kind: Kind) -> Iterator[str]:
    facets: list[tuple[str, str | int | None]] = [
        ("minInclusive", f"{kind.least:.15g}" if math.isfinite(kind.least) else None),
        ("maxInclusive", f"{kind.most:.15g}" if math.isfinite(kind.most) else None),
        ("minLength", kind.shortest or None),
        ("maxLength", kind.longest),
        ("pattern", kind.pattern or None),
        *(("enumeration", option) for option in kind.options),
    ]
    for facet, value in facets:
        if value is not None:
            yield f"<xs:{facet}{attributes(('value', value))}/>"


def _about(text: str) -> list[str]:
    if not text:
        return []
    return [f"<xs:annotation><xs:documentation>{escape_text(text)}</xs:documentation></xs:annotation>"]


def _element(head: str, inside: list[str], name: str) -> list[str]:
    return _inside(f"{head}>", inside, f"</{name}>") if inside else [f"{head}/>"]


def _inside(head: str, lines: list[str], end: str) -> list[str]:
    return [head, *_deeper(lines), end]


def _deeper(lines: list[str]) -> list[str]:
    return [f"  {line}" for line in lines]


if __name__ == "__main__":
    raise SystemExit(main())
