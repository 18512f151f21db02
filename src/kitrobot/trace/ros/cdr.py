"""Messages of ROS 2 in CDR (XCDR1, little-endian), as the middleware and MCAP carry them.

A value stands at a multiple of its size, counted from behind the four bytes that say how the message is encoded. A
string is its length with the closing zero, its bytes, and the zero; a sequence is its length and its values. Source:
OMG, *DDS for Extensible and Dynamic Topic Types* 1.3, section 7.4.
"""

from __future__ import annotations

import struct
from collections.abc import Callable, Sequence
from typing import Final

ENCAPSULATION: Final = b"\x00\x01\x00\x00"

_SIZES: Final = {"d": 8, "i": 4, "I": 4, "Q": 8, "B": 1}


class CdrLayout:
    """A message whose strings and lengths never change: its numbers are put in by one call.

    Fields are named in order with `text`, `length` and `numbers`; then `encode` makes a message of the numbers alone.
    """

    def __init__(self) -> None:
        self._bytes = bytearray(ENCAPSULATION)
        self._runs: list[tuple[int, str]] = []
        """Where numbers stand next to each other, and which."""
        self._packers: list[tuple[Callable[..., None], int, int, int]] = []

    def numbers(self, kinds: str) -> CdrLayout:
        """Numbers that each message has anew, by the letters of `struct`: d, i, I, Q, B."""
        for kind in kinds:
            self._align(_SIZES[kind])
            end = len(self._bytes)
            if self._runs and self._runs[-1][0] + struct.calcsize(f"<{self._runs[-1][1]}") == end:
                self._runs[-1] = (self._runs[-1][0], self._runs[-1][1] + kind)
            else:
                self._runs.append((end, kind))
            self._bytes += bytes(_SIZES[kind])
        return self

    def text(self, text: str) -> CdrLayout:
        """A string that is the same in each message."""
        data = text.encode() + b"\0"
        self.length(len(data))
        self._bytes += data
        return self

    def length(self, count: int) -> CdrLayout:
        """The length of a sequence, the same in each message."""
        self._align(4)
        self._bytes += struct.pack("<I", count)
        return self

    def encode(self, numbers: Sequence[float]) -> bytes:
        """A message of these numbers, in the order of the fields.

        Raises:
            ValueError: there are more or fewer numbers than the layout has.
            struct.error: a whole number is beyond its field.
        """
        if not self._packers:
            first = 0
            for place, kinds in self._runs:
                self._packers.append((struct.Struct(f"<{kinds}").pack_into, place, first, first + len(kinds)))
                first += len(kinds)
        if len(numbers) != (self._packers[-1][3] if self._packers else 0):
            raise ValueError(f"{len(numbers)} numbers for another layout")
        message = self._bytes
        for pack_into, place, first, last in self._packers:
            pack_into(message, place, *numbers[first:last])
        return bytes(message)

    def _align(self, size: int) -> None:
        self._bytes += bytes(-(len(self._bytes) - len(ENCAPSULATION)) % size)


def encode_texts(stamp: tuple[int, int], texts: Sequence[str], whole: Sequence[int] | None = None) -> bytes:
    """A message of a time (seconds, nanoseconds), strings, and, where `whole` is given, a sequence of int32."""
    layout = CdrLayout().numbers("iI")
    for text in texts:
        layout.text(text)
    if whole is not None:
        layout.length(len(whole)).numbers("i" * len(whole))
    return layout.encode([*stamp, *(whole or ())])


def encode_text(text: str) -> bytes:
    """A `std_msgs/msg/String`."""
    return CdrLayout().text(text).encode(())
