"""From offsets to lines and columns, which count from 1; columns count characters. Lines end with a line feed."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable
from functools import cached_property
from typing import TypeVar

T = TypeVar("T", str, bytes)


class TextPositions:
    """Positions in a text, by offsets of characters."""

    def __init__(self, text: str) -> None:
        self._text = text

    @cached_property
    def line_starts(self) -> list[int]:
        """The offset of each line's first character."""
        return _line_starts(self._text.find, "\n")

    def position(self, offset: int) -> tuple[int, int]:
        """Line and column of an offset."""
        line = bisect_right(self.line_starts, offset)
        return line, offset - self.line_starts[line - 1] + 1


class BytePositions:
    """Positions in UTF-8, by offsets of bytes, as the XML parser gives them.

    Offsets are those of whole characters. The last position is remembered, so that going through one long line forwards
    costs as much as reading it once.
    """

    def __init__(self, data: bytes) -> None:
        self._data = data
        self._last = (0, 1)

    @cached_property
    def _starts(self) -> list[int]:
        return _line_starts(self._data.find, b"\n")

    @cached_property
    def _is_ascii(self) -> bool:
        return self._data.isascii()

    def position(self, offset: int) -> tuple[int, int]:
        """Line and column of an offset."""
        line = bisect_right(self._starts, offset)
        start = self._starts[line - 1]
        if self._is_ascii:
            return line, offset - start + 1
        at, column = self._last
        if not start <= at <= offset:
            at, column = start, 1
        column += len(self._data[at:offset].decode())
        self._last = (offset, column)
        return line, column


def _line_starts(find: Callable[[T, int], int], line_feed: T) -> list[int]:
    starts = [0]
    at = find(line_feed, 0)
    while at >= 0:
        starts.append(at + 1)
        at = find(line_feed, at + 1)
    return starts
