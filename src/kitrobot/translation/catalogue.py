"""The catalogue of one language: a gettext `.po` file beside this module, read when it is first asked for.

An entry is found by its context (msgctxt) and its English template (msgid). A template that counts has one translation
for each plural form of the language; `Plural-Forms` of the header says which number takes which.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterator
from functools import cache
from gettext import c2py
from importlib.resources import files

from kitrobot.text.sentences import Sentence

_PLURAL = re.compile(r"plural=([^;]+);")


class Catalogue:
    """The entries of one language."""

    def __init__(self, text: str) -> None:
        self.entries: dict[tuple[str, str], list[str]] = {}
        self.plurals: dict[tuple[str, str], str] = {}
        """The templates for other numbers than one, "" where a sentence counts nothing."""
        for entry in _entries(text):
            forms = [entry[key] for key in sorted(entry) if key.startswith("msgstr")]
            if all(forms):
                key = entry.get("msgctxt", ""), entry["msgid"]
                self.entries[key], self.plurals[key] = forms, entry.get("msgid_plural", "")
        rule = _PLURAL.search(self.entries.pop(("", ""))[0])
        self.form: Callable[[int], int] = c2py(rule[1]) if rule is not None else int

    def template(self, sentence: Sentence) -> str | None:
        """The translation of a sentence's template, in the form that its count takes; None when there is none."""
        forms = self.entries.get((sentence.context, sentence.template))
        if forms is None:
            return None
        return forms[self.form(int(str(sentence.values["count"])))] if len(forms) > 1 else forms[0]

    def word(self, context: str, word: str) -> str | None:
        """The translation of a word of that context; None when there is none."""
        forms = self.entries.get((context, word))
        return None if forms is None else forms[0]


def catalogue(language: str) -> Catalogue:
    """The catalogue of a language; one without entries while its file is not there: a static site brings it later."""
    try:
        return _read(language)
    except FileNotFoundError:
        return _NONE


@cache
def _read(language: str) -> Catalogue:
    return Catalogue((files("kitrobot.translation") / f"{language}.po").read_text(encoding="utf-8"))


def _entries(text: str) -> Iterator[dict[str, str]]:
    """The entries of a `.po` file, each by keyword (msgctxt, msgid, msgid_plural, msgstr, msgstr[0] …)."""
    entry: dict[str, str] = {}
    keyword = ""
    for line in text.splitlines():
        if line.startswith('"'):
            entry[keyword] += json.loads(line)
        elif line.startswith("msg"):
            keyword, _, string = line.partition(" ")
            entry[keyword] = json.loads(string)
        elif not line and entry:
            yield entry
            entry = {}
    if entry:
        yield entry


_NONE = Catalogue('msgid ""\nmsgstr "Plural-Forms: nplurals=1; plural=0;"\n')
