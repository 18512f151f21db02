r"""How a `.krtrace` file is laid out: a header, then chunks, each whole in itself, then the outcome.

    KRTRACE\n · u16 version · u32 raw length · u32 packed length · u32 CRC-32 · header (JSON, zlib)
    KRCH · u32 first tick, last tick, records · three of records, three of events, of the head · records · events (zlib)
    …
    KREN · u32 length · u32 CRC-32 · outcome (JSON)

All integers are little-endian. The three numbers of records and of events are raw length, packed length and CRC-32 of
what is packed; the last number of a chunk's head is the CRC-32 of the head before it. A chunk is written and flushed as
a whole, so a file that was cut anywhere reads up to its last whole chunk; the index is found by hopping over chunk
heads. Same records, same bytes.
"""

from __future__ import annotations

import json
import struct
import zlib
from typing import Any

MAGIC = b"KRTRACE\n"
VERSION = 2
ENDING = ".krtrace"

CHUNK_RECORDS = 500
"""Records in a chunk at most: ten seconds of a 20 ms run, so that seeking unpacks little and zlib finds much."""
CHUNK_BYTES = 1_000_000
"""Unpacked bytes after which a chunk is full, however few records it has: many robots fill it soon."""

MOST_HEADER_BYTES = 64_000_000
MOST_HEADER_LISTS = 2_000_000
MOST_CHUNK_BYTES = 64_000_000
MOST_OUTCOME_BYTES = 1_000_000
MOST_CHUNKS = 2_000_000
"""What goes beyond these can only be damage."""

VERSION_HEAD = struct.Struct("<H")
HEAD = struct.Struct("<III")
CHUNK = struct.Struct("<4s10I")
END = struct.Struct("<4sII")
CHUNK_MARK = b"KRCH"
END_MARK = b"KREN"


def as_json(data: Any) -> bytes:
    """The one way in which plain values are written here."""
    return json.dumps(data, ensure_ascii=False, separators=(",", ":")).encode(errors="replace")


def chunk_head(ticks: tuple[int, int], records: int, raw: tuple[bytes, bytes], packed: tuple[bytes, bytes]) -> bytes:
    """The head of a chunk, its own check at the end; `raw` and `packed` are of records and of events."""
    numbers = [*ticks, records]
    for plain, small in zip(raw, packed, strict=True):
        numbers += [len(plain), len(small), zlib.crc32(small)]
    head = CHUNK.pack(CHUNK_MARK, *numbers, 0)[:-4]
    return head + struct.pack("<I", zlib.crc32(head))
