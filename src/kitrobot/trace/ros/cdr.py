"""Messages of ROS 2 in CDR (XCDR1, little-endian), as the middleware and MCAP carry them.

A value stands at a multiple of its size, counted from behind the four bytes that say how the message is encoded. A
string is its length with the closing zero, its bytes, and the zero; a sequence is its length and its values. Source:
OMG, *DDS for Extensible and Dynamic Topic Types* 1.3, section 7.4.
"""

from __future__ import annotations

import struct
from collections.abc import Sequence
from functools import lru_cache
from typing import TYPE_CHECKING, Any, Final

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

ENCAPSULATION: Final = b"\x00\x01\x00\x00"

_STAMP: Final = struct.Struct("<iI")
_SIZES: Final = {"d": 8, "i": 4, "I": 4, "B": 1}


class CdrLayout:
    """A message whose strings and lengths never change: numbers are put between them, into one message or into many.

    Fields are named in order with `text`, `length`, `numbers` and `zeros`.
    """

    def __init__(self) -> None:
        self._bytes = bytearray(ENCAPSULATION)
        self._numbers: list[tuple[int, str]] = []
        """Where each number stands, and which."""

    def numbers(self, kinds: str) -> CdrLayout:
        """Numbers that each message has anew, by the letters of `struct`: d, i, I, B."""
        for kind in kinds:
            self._align(_SIZES[kind])
            self._numbers.append((len(self._bytes), f"<{kind}"))
            self._bytes += bytes(_SIZES[kind])
        return self

    def zeros(self, kinds: str) -> CdrLayout:
        """Numbers that are 0 in each message."""
        for kind in kinds:
            self._align(_SIZES[kind])
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
        message = bytearray(self._bytes)
        for (place, kind), number in zip(self._numbers, numbers, strict=True):
            struct.pack_into(kind, message, place, number)
        return bytes(message)

    def encode_rows(self, numbers: NDArray[Any]) -> NDArray[np.uint8]:
        """A message of each row of numbers; each is a row of bytes.

        Raises:
            ValueError: there are more or fewer columns than the layout has numbers.
        """
        import numpy as np  # Messages of a run that is on need none of it.

        messages = np.tile(np.frombuffer(self._bytes, np.uint8), (len(numbers), 1))
        for (place, kind), column in zip(self._numbers, numbers.T, strict=True):
            data = column.astype(kind)
            messages[:, place : place + data.itemsize] = data.view(np.uint8).reshape(-1, data.itemsize)
        return messages

    def _align(self, size: int) -> None:
        self._bytes += bytes(-(len(self._bytes) - len(ENCAPSULATION)) % size)


def encode_texts(stamp: tuple[int, int], texts: tuple[str, ...], whole: tuple[int, ...] | None = None) -> bytes:
    """A message of a time (seconds, nanoseconds), strings, and, where `whole` is given, a sequence of int32.

    Raises:
        struct.error: a number is beyond 32 bits.
    """
    return ENCAPSULATION + _STAMP.pack(*stamp) + _after_stamp(texts, whole)


@lru_cache(1000)
def _after_stamp(texts: tuple[str, ...], whole: tuple[int, ...] | None) -> bytes:
    """Commands of a run say few different things."""
    layout = CdrLayout().numbers("iI")
    for text in texts:
        layout.text(text)
    if whole is not None:
        layout.length(len(whole)).numbers("i" * len(whole))
    return layout.encode((0, 0, *(whole or ())))[len(ENCAPSULATION) + _STAMP.size :]


def encode_text(text: str) -> bytes:
    """A `std_msgs/msg/String`."""
    return CdrLayout().text(text).encode(())
