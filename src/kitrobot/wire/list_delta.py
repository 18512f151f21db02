"""The difference of two lists: ranges of the old list that stay, and new items as they are.

A row is a new item, or a range (from, to) of the old list, `to` exclusive. So a list of a thousand vertices in which
one was edited is two ranges and a vertex, whichever end sends it. The items may be of any type.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Sequence
from typing import Any, TypeVar

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.text.affixes import common_affixes
from kitrobot.text.sentences import Sentence

Item = TypeVar("Item")


class DeltaError(KitRobotError):
    """Rows that do not fit the old list."""


def apply_delta(rows: Sequence[Item | tuple[int, int]], before: Sequence[Item], most: int) -> list[Item]:
    """The new list; items that stayed are the same objects.

    Raises:
        DeltaError: a range is outside the old list, or there would be more than `most` items.
    """
    found: list[Item] = []
    for row in rows:
        if not isinstance(row, tuple):
            found.append(row)
            continue
        start, end = row
        if not 0 <= start < end <= len(before):
            raise DeltaError(
                Sentence("a list of {count} has no stretch from {start} to {end}", len(before), start, end),
                Sentence("load the page again"),
            )
        found += before[start:end]
        if len(found) > most:
            raise DeltaError(
                Sentence("this program has a list of more than {most}", most), Sentence("make the program smaller")
            )
    return found


def encode_delta(
    before: Sequence[Item], after: Sequence[Item], name: Callable[[Item], Hashable], written: Callable[[Item], Any]
) -> list[Any]:
    """The rows that turn `before` into `after`. Equal items of one name stayed; `written` encodes a new one."""
    start, tail = common_affixes(before, after)
    if start + tail == len(before) == len(after):
        return [[0, len(after)]] if after else []
    rows = _encode_rows(before, after[start : len(after) - tail], name, written)
    if start:
        rows = _joined([[0, start]], rows)
    return _joined(rows, [[len(before) - tail, len(before)]]) if tail else rows


def _joined(rows: list[Any], more: list[Any]) -> list[Any]:
    """Both lists of rows, with adjacent ranges joined."""
    if rows and more and isinstance(rows[-1], list) and isinstance(more[0], list) and rows[-1][1] == more[0][0]:
        return [*rows[:-1], [rows[-1][0], more[0][1]], *more[1:]]
    return [*rows, *more]


def _encode_rows(
    before: Sequence[Item], after: Sequence[Item], name: Callable[[Item], Hashable], written: Callable[[Item], Any]
) -> list[Any]:
    if not after:
        return []
    places = {id(one): at for at, one in enumerate(before)}
    named: dict[Hashable, int] | None = None
    rows: list[Any] = []
    for one in after:
        at = places.get(id(one))
        if at is None:
            named = {name(was): at for at, was in enumerate(before)} if named is None else named
            at = named.get(name(one))
            if at is not None and before[at] != one:
                at = None
        if at is None:
            rows.append(written(one))
        elif rows and isinstance(rows[-1], list) and rows[-1][1] == at:
            rows[-1][1] += 1
        else:
            rows.append([at, at + 1])
    return rows
