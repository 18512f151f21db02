"""Suggestions for a misspelt word: the known word that is most like it, for help lines.

Comparing words is expensive. `nearest` compares with the first `_COMPARED` known words only; code that goes through a
file, which may hold any number of misspelt words, uses `Suggestions`, which stops after `MOST_COMPARISONS`.
"""

from __future__ import annotations

import difflib
from collections.abc import Iterable
from itertools import islice

from kitrobot.text.sentences import Help, Sentence

_COMPARED = 1000
"""Known words that an unknown one is compared with, at most."""

MOST_COMPARISONS = 100_000
"""Comparisons made for the help lines of one file or program: thousands of lines where hundreds of words are known."""

_LONGEST_GUESS = 100
"""Characters of a misspelt word that are compared, at most."""

_GUESSES = 5
"""Words that are alike enough to be looked at closely, at most."""


class Suggestions:
    """The nearest words for the misspelt ones of one file or program, the first ones of very many."""

    def __init__(self) -> None:
        self._left = MOST_COMPARISONS

    def nearest(self, word: str, words: Iterable[str]) -> str:
        """The known word that a misspelt one is most like; "" where none is near, and after `MOST_COMPARISONS`.

        Near are words that become one another by few changes: one, and one more for each three letters beyond five.
        """
        if self._left <= 0:
            return ""
        known = list(islice(words, _COMPARED))
        self._left -= len(known)
        for candidate in known:
            if candidate.casefold() == word.casefold():
                return candidate
        word = word[:_LONGEST_GUESS]
        alike = difflib.get_close_matches(word, known, _GUESSES, 0.6)
        return next((one for one in alike if _changes(word.casefold(), one.casefold()) <= max(1, len(word) // 3)), "")

    def did_you_mean(self, word: str, words: Iterable[str]) -> Help:
        """`did you mean X?` for a help line, or ""."""
        near = self.nearest(word, words)
        return Sentence("did you mean {near}?", near) if near else ""


def nearest(word: str, words: Iterable[str]) -> str:
    """The known word that a misspelt one is most like, or ""."""
    return Suggestions().nearest(word, words)


def did_you_mean(word: str, words: Iterable[str]) -> Help:
    """`did you mean X?` for a help line, or ""."""
    return Suggestions().did_you_mean(word, words)


def _changes(one: str, other: str) -> int:
    """How many letters are changed, put in, taken out, or swapped with the next, from one word to the other."""
    before, row = [0] * (len(other) + 1), list(range(len(other) + 1))
    for i, letter in enumerate(one, 1):
        last, row, before = before, [i], row
        for j, wanted in enumerate(other, 1):
            least = min(before[j] + 1, row[j - 1] + 1, before[j - 1] + (letter != wanted))
            if i > 1 and j > 1 and letter == other[j - 2] and one[i - 2] == wanted:
                least = min(least, last[j - 2] + 1)
            row.append(least)
    return row[-1]
