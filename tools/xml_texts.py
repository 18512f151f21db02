"""Takes the texts of the shipped XML out for a translator, and puts their translations in beside the English ones.

    python tools/xml_texts.py LANGUAGE           writes those without a translation as a table: {"English": "", …}
    python tools/xml_texts.py LANGUAGE TABLE     puts the translations of the table (a JSON file) into the XML

A text is an element of `TEXTS` without `xml:lang`; where a `<label>` has none, English readers see the `name` around
it. Its translations follow it in the order of their codes, as KitRobot writes them. Nothing but the new elements
changes in a file, and a translation that is there already stays: where one English text needs two translations, the
second is written by hand.
"""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from xml.parsers import expat
from xml.sax.saxutils import escape

ROOT = Path(__file__).resolve().parents[1]
FOLDERS = (ROOT / "src" / "kitrobot", ROOT / "examples")
TEXTS = frozenset({"aim", "help", "hint", "label", "phrase", "step", "supply", "word"})
"""Elements that hold a text for people, where no element is inside."""

_LETTERS = re.compile(r"[^\W\d_]")
_HOLE = re.compile(r"\{\w+\}")


@dataclass
class _Element:
    name: str
    attributes: Mapping[str, str]
    begin: int
    end: int = 0
    text: str = ""
    children: list[_Element] = field(default_factory=list)


@dataclass
class Text:
    """An English text with its translations by language; each ends at a byte of its file ("" for the English one)."""

    element: str
    english: str
    translations: set[str]
    ends: dict[str, int]
    begin: int


def texts_of(source: bytes) -> list[Text]:
    """The texts of an XML file, in reading order."""
    return list(_texts(_root(source)))


def lacking(source: bytes, language: str) -> Iterator[Text]:
    """The texts that have words, and none in that language."""
    for text in texts_of(source):
        if language not in text.translations and _LETTERS.search(_HOLE.sub("", text.english)):
            yield text


def put_in(source: bytes, language: str, table: Mapping[str, str]) -> bytes:
    """The file with the translations that it lacks and the table has."""
    made = source
    for text in sorted(lacking(source, language), key=lambda text: text.begin, reverse=True):
        if translation := table.get(text.english):
            added = f'<{text.element} xml:lang="{language}">{escape(translation)}</{text.element}>'.encode()
            before = [code for code in text.ends if code < language]
            at = text.ends[max(before)] if before else text.begin
            indent = _line_break(source, text.begin)
            made = made[:at] + (indent + added if before else added + indent) + made[at:]
    return made


def _root(source: bytes) -> _Element:
    """The elements of a file, each with the bytes where it begins and ends."""
    document = _Element("", {}, 0)
    around = [document]
    parser = expat.ParserCreate()
    parser.buffer_text = True

    def start(name: str, attributes: dict[str, str]) -> None:
        element = _Element(name, attributes, parser.CurrentByteIndex)
        around[-1].children.append(element)
        around.append(element)

    def end(_: str) -> None:
        around.pop().end = source.index(b">", parser.CurrentByteIndex) + 1

    def words(data: str) -> None:
        around[-1].text += data

    parser.StartElementHandler, parser.EndElementHandler, parser.CharacterDataHandler = start, end, words
    parser.Parse(source, True)
    return document


def _texts(around: _Element) -> Iterator[Text]:
    text: Text | None = None
    for child in around.children:
        if child.children or child.name not in TEXTS:
            text = None
            yield from _texts(child)
            continue
        language = child.attributes.get("xml:lang", "")
        if text is None or text.element != child.name or not language:
            text = Text(child.name, around.attributes.get("name", ""), set(), {}, child.begin)
            yield text
        if language:
            text.translations.add(language)
        else:
            text.english = " ".join(child.text.split())
        text.ends[language] = child.end


def _line_break(source: bytes, at: int) -> bytes:
    """The break and the blanks before an element that begins its line; nothing where it does not."""
    line = source.rindex(b"\n", 0, at) + 1
    return b"" if source[line:at].strip() else b"\n" + source[line:at]


def xml_files() -> list[Path]:
    """The shipped files with texts."""
    return sorted(path for folder in FOLDERS for ending in ("*.xml", "*.krt") for path in folder.rglob(ending))


def main() -> int:
    if len(sys.argv) not in (2, 3):
        print(__doc__)
        return 2
    language = sys.argv[1]
    if len(sys.argv) == 3:
        table = json.loads(Path(sys.argv[2]).read_text(encoding="utf-8"))
        for path in xml_files():
            source = path.read_bytes()
            if (made := put_in(source, language, table)) != source:
                path.write_bytes(made)
    found = {text.english: "" for path in xml_files() for text in lacking(path.read_bytes(), language)}
    if len(sys.argv) == 2 or found:
        print(json.dumps(found, ensure_ascii=False, indent=1))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
