"""UF2 files: blocks of 512 bytes, each with its magic numbers, where its bytes go, its number and how many there are,
and the family of chips that it is for.

Boards skip blocks that are marked as none for the flash: a mission travels in them. Source: Microsoft's specification
of UF2, and the boot ROMs of the RP2040 and RP2350. A file comes from anywhere: its size is bounded, and it is whole
or refused. Left to others: what the bytes mean.
"""

from __future__ import annotations

import struct
from collections.abc import Iterable
from typing import NamedTuple

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.text.sentences import Sentence

BLOCK = 512
LARGEST_BYTES = 64 * 1024 * 1024
"""Of a file; the flash of no board holds more."""

ABSOLUTE = 0xE48BFF57
"""The family of the one block with which a file for the RP2350 begins, and which counts for itself."""

MAGIC = struct.pack("<II", 0x0A324655, 0x9E5D5157)
_LAST = struct.pack("<I", 0x0AB16F30)
_HEAD = struct.Struct("<8s6I")
_NOT_FLASH, _HAS_FAMILY = 0x00000001, 0x00002000
_MOST_PAYLOAD = 476


class Uf2Error(KitRobotError):
    """A file is none, or damaged; `reason` says why, as a clause."""

    def __init__(self, name: str, reason: Sentence) -> None:
        super().__init__(
            Sentence("`{file}` is no UF2 file that is whole: {reason}", name, reason),
            Sentence("get the file once more, or make it again from the mission"),
        )
        self.reason = reason


class Uf2Block(NamedTuple):
    """A block: its bytes go to `address` of the chips of `family`, 0 for any. `raw` is the whole of it."""

    address: int
    payload: bytes
    family: int
    raw: bytes


class Uf2File(NamedTuple):
    """What is in a file: blocks for the flash in their order, and the bytes of those that boards skip."""

    blocks: tuple[Uf2Block, ...]
    other: bytes = b""


def read_uf2(data: bytes, name: str) -> Uf2File:
    """A UF2 file's bytes.

    Raises:
        Uf2Error: it is damaged, cut off or none; the message says where.
    """
    if len(data) > LARGEST_BYTES:
        raise Uf2Error(name, Sentence("it has more than {most} bytes", LARGEST_BYTES))
    if data[:8] != MAGIC:
        raise Uf2Error(name, Sentence("it does not begin as a UF2 file does"))
    if len(data) % BLOCK:
        raise Uf2Error(name, Sentence("it is cut off in its block {number}", len(data) // BLOCK + 1))
    seen: dict[int, tuple[int, set[int]]] = {}
    blocks: list[Uf2Block] = []
    other: dict[int, bytes] = {}
    for number, at in enumerate(range(0, len(data), BLOCK), 1):
        raw = data[at : at + BLOCK]
        magic, flags, address, size, place, count, family = _HEAD.unpack_from(raw)
        if magic != MAGIC or raw[-4:] != _LAST:
            raise Uf2Error(name, Sentence("its block {number} is damaged", number))
        if size > _MOST_PAYLOAD or place >= count:
            raise Uf2Error(name, Sentence("its block {number} says what cannot be", number))
        family = family if flags & _HAS_FAMILY else 0
        known = seen.setdefault(family, (count, set()))
        if known[0] != count or place in known[1]:
            raise Uf2Error(name, Sentence("its block {number} does not fit the others", number))
        known[1].add(place)
        payload = raw[_HEAD.size : _HEAD.size + size]
        if flags & _NOT_FLASH:
            other[place] = payload
        else:
            blocks.append(Uf2Block(address, payload, family, raw))
    for family, (count, places) in seen.items():
        if len(places) != count and family != ABSOLUTE:
            raise Uf2Error(name, Sentence("{missing} of its {count} blocks are missing", count - len(places), count))
    return Uf2File(tuple(blocks), b"".join(other[place] for place in sorted(other)))


def write_uf2(family: int, pages: Iterable[tuple[int, bytes]], other: bytes, before: bytes = b"") -> bytes:
    """A UF2 file.

    What boards skip stands before the last block: a board that has all of its own blocks restarts, and a computer that
    were still to write would call that a failure.

    Args:
        family: of the chips.
        pages: bytes and their addresses; those of one sector of the flash one after another.
        other: what boards skip.
        before: whole blocks that come first.
    """
    found = list(pages)
    blocks = [
        _block(_HAS_FAMILY, (address, len(content), place, len(found), family), content)
        for place, (address, content) in enumerate(found)
    ]
    pieces = [other[at : at + _MOST_PAYLOAD] for at in range(0, len(other), _MOST_PAYLOAD)]
    skipped = [_block(_NOT_FLASH, (0, len(piece), place, len(pieces), 0), piece) for place, piece in enumerate(pieces)]
    return b"".join([before, *blocks[:-1], *skipped, *blocks[-1:]])


def _block(flags: int, head: tuple[int, int, int, int, int], payload: bytes) -> bytes:
    return _HEAD.pack(MAGIC, flags, *head) + payload.ljust(_MOST_PAYLOAD, b"\0") + _LAST
