"""An English sentence with its holes filled → the same sentence in another language.

A table's key is a sentence with numbered holes, "the robot `{1}` has no `{2}`"; its value the same in the other
language, the holes in any order, as often as needed or not at all. A sentence belongs to the key with the most letters
of its own that fits; between two stretches of the key a hole takes as little as it can. What stood in a hole is said
in the other language too when it is itself a sentence, a word of the table, a list of such, or such clauses with
semicolons between them, and stays as it is otherwise: names, numbers, code. Between back quotes only the names of parts
are translated, as the canvas shows them.

A table has four sections: "sentences", which the rooms say; "phrases", which are never said alone; "words", single
ones and what holds them together; "parts", names of constructors and their slots.

A key does not care whether the sentence begins with a capital or ends with a full stop: what comes out does as what
went in. In a language that runs from right to left, what stays English is set apart (U+2068 … U+2069), so that the
name in the middle of a sentence does not turn its surroundings about.

The work is bounded whatever a name may hold: stretches are looked for once each, from left to right, without going
back; sentences longer than `LONGEST` stay English; sentences in sentences are looked at `DEEPEST` levels deep.
"""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache, lru_cache
from importlib.resources import files

ENGLISH = "en"
DIRECTIONS = {ENGLISH: "ltr", "fr": "ltr", "ur": "rtl"}
LANGUAGES = tuple(DIRECTIONS)
"""Languages that can be asked for."""

LONGEST = 4000
DEEPEST = 4
REMEMBERED = 2048

_STOPS = {ENGLISH: ".", "fr": ".", "ur": "۔"}
_COMMAS = {ENGLISH: ", ", "fr": ", ", "ur": "، "}
_CLAUSES = {ENGLISH: "; ", "fr": " ; ", "ur": "؛ "}
_MOST_CLAUSES = 10
_HOLE = re.compile(r"\{([0-9]+)\}")
_JOINTS = re.compile(r"(, | and | or )")
_NUMBER = re.compile(r"-?[0-9]+(\.[0-9]+)?")
_PREFIX = 4
"""Letters at the beginning of a key by which it is found, fewer where it begins with fewer."""


@dataclass(frozen=True)
class _Sentence:
    """A key, cut at its holes, and what it is in the other language: text and numbers of holes by turns."""

    stretches: tuple[str, ...]
    said: tuple[str, ...]
    weight: int
    is_phrase: bool

    def holes(self, text: str) -> list[str] | None:
        """What stands in the holes when the text is this sentence."""
        first, *middle, last = self.stretches
        if not text.startswith(first) or not text.endswith(last) or len(text) < len(first) + len(last):
            return None
        at, end = len(first), len(text) - len(last)
        found = []
        for stretch in middle:
            begin = text.find(stretch, at, end)
            if begin < 0:
                return None
            found.append(text[at:begin])
            at = begin + len(stretch)
        found.append(text[at:end])
        # A name between back quotes has none in it: else this is another sentence that begins and ends alike.
        if any("`" in hole for hole, before in zip(found, self.stretches, strict=False) if before.endswith("`")):
            return None
        return found


class Table:
    """The sentences and words of one language."""

    def __init__(self, language: str, sections: Mapping[str, Mapping[str, str]]) -> None:
        self.language = language
        self._parts = {english: other for english, other in sections["parts"].items() if other}
        self._whole: dict[str, str] = dict(self._parts)
        self._beginning: dict[str, list[_Sentence]] = {}
        keys = [
            (_bare(english, ENGLISH), _bare(other, language), section == "phrases")
            for section in ("words", "phrases", "sentences")
            for english, other in sections[section].items()
            if other
        ]
        for english, other, is_phrase in sorted(keys, key=lambda key: -len(_HOLE.sub("", key[0]))):
            stretches = tuple(_HOLE.split(english)[::2])
            if len(stretches) == 1:
                self._whole.setdefault(english, other)
            else:
                weight = sum(map(len, stretches))
                sentence = _Sentence(stretches, tuple(_HOLE.split(other)), weight, is_phrase)
                self._beginning.setdefault(stretches[0][:_PREFIX], []).append(sentence)

    def translate(self, text: str) -> str:
        """The text in this language; as it is when it is no sentence of the table."""
        if len(text) > LONGEST:
            return text
        found = self._sentence(text, DEEPEST)
        return text if found is None else found if text[:1].isspace() else found.strip()

    def _sentence(self, text: str, depth: int) -> str | None:
        """A sentence, whether or not it begins large and ends with a full stop."""
        bare = _bare(text, ENGLISH)
        found = self._found(bare, text[0] + bare[1:], depth) if depth and bare else None
        if found is None:
            return None
        if text[:1] != bare[:1]:
            found = found[:1].upper() + found[1:]
        return found + _STOPS[self.language] if text.endswith(".") and not bare.endswith(".") else found

    def _found(self, bare: str, as_written: str, depth: int) -> str | None:
        whole = self._whole.get(as_written) or self._whole.get(bare)
        if whole is not None:
            return whole
        best = None
        for length in range(min(_PREFIX, len(bare)), -1, -1):
            for sentence in self._beginning.get(bare[:length], ()):
                if best is not None and sentence.weight <= best[0].weight:
                    break  # the others of this beginning have fewer letters
                if sentence.is_phrase and depth == DEEPEST:
                    continue
                # The first letter is the key's, or that of a name.
                holes = sentence.holes(bare if sentence.stretches[0] else as_written)
                if holes is not None:
                    best = sentence, holes
        return None if best is None else self._filled(best[0].said, best[1], depth - 1)

    def _filled(self, said: tuple[str, ...], holes: list[str], depth: int) -> str:
        made: list[str] = []
        quoted = False
        for index, piece in enumerate(said):
            if index % 2:
                hole = holes[int(piece) - 1] if int(piece) <= len(holes) else ""
                made.append(self._parts.get(hole, hole) if quoted else self._hole(hole, depth))
            else:
                made.append(piece)
                quoted ^= bool(piece.count("`") % 2)
        return "".join(made)

    def _hole(self, hole: str, depth: int) -> str:
        """What a hole was filled with: words, a list of them, a sentence, or what has no translation."""
        bare = hole.strip()
        if not bare:
            return hole
        found: str | None
        if _is_quoted(bare):
            found = bare[0] + self._parts.get(bare[1:-1], bare[1:-1]) + bare[-1] if _is_code(bare) else None
        else:
            whole = self._sentence(hole, depth) if bare != hole else None
            if whole is not None:
                return whole
            found = self._whole.get(bare) or self._clauses(bare, depth)
            found = found or self._list(bare, depth) or self._sentence(bare, depth)
        begin = hole.index(bare)
        return hole[:begin] + (found or self._apart(bare)) + hole[begin + len(bare) :]

    def _clauses(self, text: str, depth: int) -> str | None:
        """`a waits; b has no box`, when each clause is known."""
        clauses = text.split("; ")
        if len(clauses) == 1 or len(clauses) > _MOST_CLAUSES:
            return None
        made = [
            self._whole.get(one) or self._list(one, depth) or self._sentence(one, depth) if " " in one else None
            for one in clauses
        ]
        known = [one for one in made if one is not None]
        return _CLAUSES[self.language].join(known) if len(known) == len(made) else None

    def _list(self, text: str, depth: int) -> str | None:
        """`a, b or c`, when each of them is one word, quoted, or known."""
        parts = _JOINTS.split(text)
        if len(parts) == 1 or len(parts) > 101:
            return None
        made = []
        for index, part in enumerate(parts):
            if index % 2:
                joint = part.strip()
                made.append(_COMMAS[self.language] if joint == "," else f" {self._whole.get(joint, joint)} ")
                continue
            # A word alone is a name among others, whatever it would mean elsewhere.
            found = self._sentence(part, depth) if " " in part else None
            if found is None and " " in part.removesuffix(" …") and not _is_quoted(part):
                return None
            made.append(self._apart(part) if found is None else found)
        return "".join(made)

    def _apart(self, text: str) -> str:
        """What stays as it is, in a way that it does not disturb the direction of the sentence."""
        if _NUMBER.fullmatch(text):
            return text.replace(".", ",") if self.language == "fr" else text
        if DIRECTIONS[self.language] == "ltr" or _is_code(text):
            return text
        return f"\u2068{text}\u2069"


def _is_code(text: str) -> bool:
    """Whether it stands between back quotes, and so is set apart by whoever shows it."""
    return len(text) > 1 and text[0] == text[-1] == "`"


def _is_quoted(text: str) -> bool:
    """Whether it is one name between quotation marks, whatever is in it."""
    return (text[:1], text[-1:]) in (("`", "`"), ("“", "”")) and text[-1] not in text[1:-1]


def _bare(text: str, language: str) -> str:
    """The text without its full stop, its first letter small when that is no name in capitals."""
    stop = _STOPS[language]
    bare = text[: -len(stop)] if text.endswith(stop) and not text.endswith(stop * 2) else text
    return bare[:1].lower() + bare[1:] if language == ENGLISH and not bare[1:2].isupper() else bare


@cache
def _table(language: str) -> Table:
    text = (files("kitrobot.translation") / f"{language}.json").read_text(encoding="utf-8")
    loaded = json.loads(text)
    return Table(language, loaded)


@lru_cache(REMEMBERED)
def translated(text: str, language: str) -> str:
    """The sentence in that language, or as it is where there is no translation."""
    return text if language not in LANGUAGES or language == ENGLISH or not text else _table(language).translate(text)
