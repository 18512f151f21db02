"""Brings the catalogues of the translators (`.po`) up to date with the sentences of the program.

    python tools/sentences.py            lists what has no French or no Urdu yet, and what is translated for nothing
    python tools/sentences.py --write    adds those to the catalogues without a translation, and takes the others out

Found are the templates of `Sentence`, `Sentence.counted` and `Recorded`, and the explanations of rules. Entries of the
contexts "word" and "part" are kept by hand: they come from data, not from literals.
"""

from __future__ import annotations

import ast
import sys
from collections.abc import Iterator
from pathlib import Path

from babel.messages.catalog import Catalog, Message
from babel.messages.pofile import read_po, write_po

ROOT = Path(__file__).resolve().parents[1]
SOURCES = ROOT / "src" / "kitrobot"
TABLES = SOURCES / "translation"
LANGUAGES = ("fr", "ur")

TERMINAL = (
    "cli/",
    "files/forms.py",
    "image/",
    "server/start.py",
    "workspace/checking.py",
    "workspace/conversion.py",
    "workspace/executables.py",
    "workspace/inputs.py",
    "workspace/watching.py",
)
"""What speaks only in a terminal, in English."""

BY_HAND = ("word", "part")
"""Contexts whose entries stand in no literal."""

_CONTEXTS = {"Sentence": None, "Recorded": "recorded"}

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


def sentences() -> Catalog:
    """Every sentence of the rooms, each with the files that say it."""
    found = Catalog()
    for path in sorted(SOURCES.rglob("*.py")):
        name = path.relative_to(SOURCES).as_posix()
        if name.startswith(TERMINAL):
            continue
        for context, id in _templates(ast.parse(path.read_text(encoding="utf-8"))):
            found.add(id, locations=[(name, 0)], context=context)
    return found


def _templates(tree: ast.AST) -> Iterator[tuple[str | None, str | tuple[str, str]]]:
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


def catalogue(language: str) -> Catalog:
    """A language's catalogue as it is in its file."""
    with (TABLES / f"{language}.po").open("rb") as stream:
        return read_po(stream, locale=language, abort_invalid=True)


def entries(known: Catalog) -> dict[Key, Message]:
    """The entries of a catalogue without its header."""
    return {(one.context, _english(one)): one for one in known if one.id}


def _english(message: Message) -> str:
    return message.id if isinstance(message.id, str) else message.id[0]


def forms(message: Message) -> tuple[str, ...]:
    """An entry's translations: one, or one for each plural form."""
    return (message.string,) if isinstance(message.string, str) else tuple(message.string or ())


def faults(language: str, said: Catalog) -> tuple[list[Key], list[Key]]:
    """What lacks a translation, and what is translated and said by nobody."""
    known, wanted = entries(catalogue(language)), entries(said)
    lacking = [
        key for key, one in wanted.items() if key not in known or known[key].id != one.id or not all(forms(known[key]))
    ]
    return lacking, [key for key in known if key not in wanted and key[0] not in BY_HAND]


def updated(language: str, said: Catalog) -> Catalog:
    """The catalogue with the sentences that are said and no others; what it knows of them is kept."""
    known = catalogue(language)
    for (context, _), one in entries(known).items():
        if context in BY_HAND:
            said.add(one.id, context=context)
    known.update(said, no_fuzzy_matching=True)
    known.obsolete.clear()
    return known


def write(language: str, known: Catalog) -> None:
    """Writes a language's catalogue."""
    with (TABLES / f"{language}.po").open("wb") as stream:
        stream.write(_HEADER.format(language=language, plurals=known.plural_forms).encode())
        write_po(stream, known, width=110, omit_header=True, include_lineno=False)


def main() -> int:
    said = sentences()
    missing = 0
    for language in LANGUAGES:
        lacking, idle = faults(language, said)
        missing += len(lacking) + len(idle)
        for _, english in lacking:
            print(f"{language}: not translated: {english}")
        for _, english in idle:
            print(f"{language}: nobody says any more: {english}")
        if "--write" in sys.argv[1:]:
            write(language, updated(language, said))
    return 1 if missing else 0


if __name__ == "__main__":
    sys.exit(main())
