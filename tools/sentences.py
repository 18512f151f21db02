"""Brings the catalogues of the translators (`.po`) up to date with the sentences of the program and of the page.

    python tools/sentences.py            lists what some language lacks, and what is translated for nothing
    python tools/sentences.py --write    adds those to the catalogues without a translation, and takes the others out

Of the program these are the templates of `Sentence`, `Sentence.counted` and `Recorded`, and the explanations of rules;
entries of the contexts "word" and "part" come from data, not from literals, and are kept by hand. Of the page they are
the entries of the English tables, each with its key as the context.
"""

from __future__ import annotations

import ast
import copy
import json
import re
import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from babel.messages.catalog import Catalog, Message
from babel.messages.pofile import read_po, write_po

from kitrobot.translation.languages import TRANSLATED

ROOT = Path(__file__).resolve().parents[1]
SOURCES = ROOT / "src" / "kitrobot"
PAGE = ROOT / "web" / "src" / "i18n"
PAGES = (ROOT / "tools" / "kit_texts.py",)
"""What writes documents in every language."""

TERMINAL = (
    "cli/",
    "files/program_formats.py",
    "image/",
    "server/studio_server.py",
    "workspace/file_check.py",
    "workspace/conversion.py",
    "workspace/executables.py",
    "workspace/inputs.py",
    "boards/monitor.py",
)
"""What speaks only in a terminal, in English."""

_CONTEXTS = {"Sentence": None, "Recorded": "recorded"}

_STRING = r'"(?:[^"\\\n]|\\.)*"'
_ROW = re.compile(rf"({_STRING}):\s*(?:({_STRING})|\{{\s*one:\s*({_STRING}),\s*other:\s*({_STRING}),?\s*\}})")
"""A row of an English table of the page: a key, and a text or one for 1 and one for other counts."""

_HEADER = """\
# How to translate: CONTRIBUTING.md, "Sentences".
msgid ""
msgstr ""
"Language: {language}\\n"
"Plural-Forms: {plurals}\\n"
"MIME-Version: 1.0\\n"
"Content-Type: text/plain; charset=utf-8\\n"
"Content-Transfer-Encoding: 8bit\\n"

"""

Key = tuple[str | None, str]
"""Context and English template of an entry."""

Id = str | tuple[str, str]
"""The English of an entry, or that for 1 and that for other counts."""


def _of_the_program() -> Iterator[tuple[str, str | None, Id]]:
    """File, context and English of every sentence of the rooms."""
    for path in (*sorted(SOURCES.rglob("*.py")), *PAGES):
        name = path.relative_to(ROOT if path in PAGES else SOURCES).as_posix()
        if not name.startswith(TERMINAL):
            for context, id in _templates(ast.parse(path.read_text(encoding="utf-8"))):
                yield name, context, id


def _templates(tree: ast.AST) -> Iterator[tuple[str | None, Id]]:
    """Context and template (with its plural) of the sentences that a module makes, in reading order."""
    calls = [node for node in ast.walk(tree) if isinstance(node, ast.Call)]
    for call in sorted(calls, key=lambda node: (node.lineno, node.col_offset)):
        called = call.func
        texts = [arg.value if isinstance(arg, ast.Constant) and isinstance(arg.value, str) else "" for arg in call.args]
        if isinstance(called, ast.Attribute) and called.attr == "counted" and isinstance(called.value, ast.Name):
            if called.value.id in _CONTEXTS and texts[0]:
                yield _CONTEXTS[called.value.id], (texts[0], texts[1])
        elif isinstance(called, ast.Name):
            at = 3 if called.id == "rule" else 0 if called.id in _CONTEXTS else len(texts)
            if texts[at:] and texts[at]:
                yield _CONTEXTS.get(called.id), texts[at]


def _of_the_page() -> Iterator[tuple[str, str | None, Id]]:
    """File, key and English of every sentence of the page."""
    for path in sorted(PAGE.glob("en*.ts")):
        for key, *texts in _ROW.findall(path.read_text(encoding="utf-8")):
            one, *more = (json.loads(text) for text in texts if text)
            yield path.name, json.loads(key), (one, more[0]) if more else one


@dataclass(frozen=True)
class CatalogueSet:
    """The program or the page: where its catalogues are, its sentences, and the contexts that are kept by hand."""

    folder: Path
    found: Callable[[], Iterator[tuple[str, str | None, Id]]]
    by_hand: tuple[str, ...] = ()

    @cached_property
    def sentences(self) -> Catalog:
        """Every sentence, each with the files that say it; looked for once."""
        made = Catalog()
        for file, context, id in self.found():
            made.add(id, locations=[(file, 0)], context=context)
        return made

    def catalogue(self, language: str) -> Catalog:
        """A language's catalogue as it is in its file; an empty one of a language that has none yet."""
        path = self.folder / f"{language}.po"
        if not path.exists():
            return Catalog(locale=language)
        with path.open("rb") as stream:
            return read_po(stream, locale=language, abort_invalid=True)

    def faults(self, language: str) -> tuple[list[Key], list[Key]]:
        """What lacks a translation, and what is translated and said by nobody."""
        known, wanted = entries(self.catalogue(language)), entries(self.sentences)
        lacking = [
            key
            for key, one in wanted.items()
            if key not in known or known[key].id != one.id or not all(forms(known[key]))
        ]
        lacking += [key for key, one in known.items() if key[0] in self.by_hand and not all(forms(one) or ("",))]
        return lacking, [key for key in known if key not in wanted and key[0] not in self.by_hand]

    def update(self, language: str) -> None:
        """Writes the catalogue with the sentences that are said and no others; what it knows of them is kept. What is
        kept by hand in one language is there for all.
        """
        known, said = self.catalogue(language), copy.deepcopy(self.sentences)
        for other in TRANSLATED:
            for (context, _), one in entries(self.catalogue(other)).items():
                if context in self.by_hand:
                    said.add(one.id, context=context)
        known.update(said, no_fuzzy_matching=True)
        known.obsolete.clear()
        with (self.folder / f"{language}.po").open("wb") as stream:
            stream.write(_HEADER.format(language=language, plurals=known.plural_forms).encode())
            write_po(stream, known, width=110, omit_header=True, include_lineno=False)


PROGRAM = CatalogueSet(SOURCES / "translation", _of_the_program, ("word", "part", "column"))
CATALOGUE_SETS = {"program": PROGRAM, "page": CatalogueSet(PAGE, _of_the_page)}


def entries(known: Catalog) -> dict[Key, Message]:
    """The entries of a catalogue without its header."""
    return {(one.context, english(one)[0]): one for one in known if one.id}


def english(message: Message) -> tuple[str, ...]:
    """An entry's English: one text, or that for 1 and that for other counts."""
    return (message.id,) if isinstance(message.id, str) else tuple(message.id)


def forms(message: Message) -> tuple[str, ...]:
    """An entry's translations: one, or one for each plural form."""
    return (message.string,) if isinstance(message.string, str) else tuple(message.string or ())


def main() -> int:
    missing = 0
    for name, half in CATALOGUE_SETS.items():
        for language in TRANSLATED:
            lacking, idle = half.faults(language)
            missing += len(lacking) + len(idle)
            for _, text in lacking:
                print(f"{name}, {language}: not translated: {text}")
            for _, text in idle:
                print(f"{name}, {language}: nobody says any more: {text}")
            if "--write" in sys.argv[1:]:
                half.update(language)
    return 1 if missing else 0


if __name__ == "__main__":
    sys.exit(main())
