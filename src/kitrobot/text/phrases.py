"""How sentences repeat what people wrote: values in quotes, lists of names."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import islice

from kitrobot.text.sentences import COMMA, Sentence, Series

_SHOWN = 40
"""Characters of a value that a message repeats at most."""

_LISTED = 8
"""Names that a help line lists, at most."""


def shown(text: str) -> str:
    """A value as messages repeat it: quoted, shortened, without line breaks."""
    line = " ".join(text.split())
    return f"“{line if len(line) <= _SHOWN else line[: _SHOWN - 1] + '…'}”"


def one_of(options: Iterable[str]) -> str:
    """`a, b or c`."""
    *front, last = options
    return Sentence("{front} or {last}", Series(COMMA, front), last) if front else last


def all_of(names: Iterable[str]) -> str:
    """`a, b and c`; "" without any."""
    *front, last = (*names,) or ("",)
    return Sentence("{front} and {last}", Series(COMMA, front), last) if front else last


def listed(names: Iterable[str]) -> Sentence:
    """`a, b, c`: the first names, with `…` where there are more; "" without any."""
    first = list(islice(names, _LISTED + 1))
    series = Series(COMMA, first[:_LISTED])
    return Sentence("{names} …", series) if len(first) > _LISTED else series
