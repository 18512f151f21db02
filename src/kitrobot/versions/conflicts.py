"""What both sides of a merge changed differently: each such conflict, and which side is taken in it.

Ours is taken unless somebody decided otherwise. A conflict has a name that is the same each time the same three
missions are merged, so that decisions can be given one after another.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass
from typing import Any, TypeVar

from kitrobot.text.sentences import Sentence
from kitrobot.versions.phrases import short
from kitrobot.versions.phrases import value as in_words

T = TypeVar("T")


@dataclass(frozen=True)
class Conflict:
    """What both changed differently.

    Attributes:
        name: by what it is decided.
        what: what they changed.
        sentence: what they did, and what became of it.
        ours: our value in words, "" where it has none that is short.
        theirs: likewise.
        taken: whether theirs was taken.
        open: whether there is something to decide.
    """

    name: str
    what: str
    sentence: str
    ours: str = ""
    theirs: str = ""
    taken: bool = False
    open: bool = True


class Decisions:
    """The conflicts of a merge as they are found; `taken` are the names of those in which theirs is taken."""

    def __init__(self, taken: Collection[str] = (), program: str = "") -> None:
        self.taken = taken
        self.found: list[Conflict] = []
        self._program = program

    def within(self, program: str) -> Decisions:
        """For conflicts in a program: they count once they are in `found` here."""
        return Decisions(self.taken, program)

    def choose(self, what: str, one: T, mine: T, other: T) -> T:
        """The side that changed it; where both did, the one that was decided on."""
        if other in (one, mine):
            return mine
        if mine == one:
            return other
        takes = self.takes(
            what,
            Sentence("{what} was changed in both: ours is kept", what),
            Sentence("{what} was changed in both: theirs is taken", what),
            _in_words(mine),
            _in_words(other),
        )
        return other if takes else mine

    def takes(self, what: str, kept: Sentence, taken: Sentence, ours: str = "", theirs: str = "") -> bool:
        """Whether theirs is taken in a conflict; `kept` and `taken` say what becomes of it."""
        name = self._in_program(what)
        takes = str(name) in self.taken
        sentence = self._in_program(taken if takes else kept)
        self.found.append(Conflict(str(name), name, sentence, ours, theirs, takes))
        return takes

    def report(self, what: str, sentence: Sentence) -> None:
        """What there is nothing to decide about."""
        self.found.append(Conflict(str(what), what, sentence, open=False))

    def _in_program(self, words: str) -> str:
        return Sentence("{program}: {words}", self._program, words) if self._program else words


def _in_words(value: Any) -> str:
    if value is None or isinstance(value, str):
        return in_words(value)
    return short(value) if isinstance(value, int | float | dict) and not isinstance(value, bool) else ""
