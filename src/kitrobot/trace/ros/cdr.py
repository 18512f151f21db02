"""Messages of ROS 2 in CDR (XCDR1, little-endian), as the middleware and MCAP carry them.

A value stands at a multiple of its size, counted from behind the four bytes that say how the message is encoded. A
string is its length with the closing zero, its bytes, and the zero; a sequence is its length and its values. Source:
OMG, *DDS for Extensible and Dynamic Topic Types* 1.3, section 7.4.
"""

from __future__ import annotations

import struct
from collections.abc import Callable, Iterable, Sequence
from typing import Final

ENCAPSULATION: Final = b"\x00\x01\x00\x00"

_SIZES: Final = {"d": 8, "i": 4, "I": 4, "Q": 8, "B": 1}


class CdrLayout:
    """A message whose strings and lengths never change: its numbers are put in by one call.

    Fields are named in order with `text`, `length` and `numbers`; then `encode` makes a message of the numbers alone.
    """

    def __init__(self) -> None:
        self._format = ["<4s"]
        self._arguments: list[bytes | int | float] = [ENCAPSULATION]
        self._numbers: list[int] = []
        self._size = 0
        self._packer: Callable[..., bytes] | None = None

    def numbers(self, kinds: str) -> CdrLayout:
        """Numbers that each message has anew, by the letters of `struct`: d, i, I, Q, B."""
        for kind in kinds:
            self._align(_SIZES[kind])
            self._numbers.append(len(self._arguments))
            self._arguments.append(0)
            self._format.append(kind)
            self._size += _SIZES[kind]
        return self

    def text(self, text: str) -> CdrLayout:
        """A string that is the same in each message."""
        data = text.encode() + b"\0"
        self.length(len(data))
        self._arguments.append(data)
        self._format.append(f"{len(data)}s")
        self._size += len(data)
        return self

    def length(self, count: int) -> CdrLayout:
        """The length of a sequence, the same in each message."""
        self._align(4)
        self._arguments.append(count)
        self._format.append("I")
        self._size += 4
        return self

    def encode(self, numbers: Iterable[float]) -> bytes:
        """A message of these numbers, in the order of the fields.

        Raises:
            ValueError: there are more or fewer numbers than the layout has.
            struct.error: a whole number is beyond its field.
        """
        arguments = list(self._arguments)
        for place, number in zip(self._numbers, numbers, strict=True):
            arguments[place] = number
        if self._packer is None:
            self._packer = struct.Struct("".join(self._format)).pack
        return self._packer(*arguments)

    def _align(self, size: int) -> None:
        gap = -self._size % size
        if gap:
            self._format.append(f"{gap}x")
            self._size += gap


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
