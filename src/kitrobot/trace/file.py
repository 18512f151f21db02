r"""The `.krtrace` file: a header, then chunks, each whole in itself, then the outcome.

    KRTRACE\n · u16 version · u32 length · u32 CRC-32 · header (JSON)
    KRCH · u32 first tick, last tick, records, raw length, packed length, CRC-32 · packed (zlib)
    …
    KREN · u32 length · u32 CRC-32 · outcome (JSON)

All integers are little-endian. A chunk is written and flushed as a whole, so a file that was cut anywhere reads up to
its last whole chunk; the index is found by hopping over chunk heads. Same records, same bytes.
"""

from __future__ import annotations

import json
import struct
import zlib
from bisect import bisect_right
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from types import TracebackType
from typing import Any, BinaryIO

from kitrobot.trace.coding import Encoder, decode
from kitrobot.trace.model import TickRecord, TraceError, TraceHeader

MAGIC = b"KRTRACE\n"
VERSION = 1
CHUNK_RECORDS = 500
"""Records in a chunk: ten seconds of a 20 ms run, so that seeking unpacks little and zlib finds much."""
MAX_HEADER_BYTES = 64_000_000
MAX_CHUNK_BYTES = 256_000_000
"""Lengths beyond these can only be damage."""

_HEAD = struct.Struct("<HII")
_CHUNK = struct.Struct("<4sIIIIII")
_END = struct.Struct("<4sII")
_CHUNK_MARK = b"KRCH"
_END_MARK = b"KREN"


def _json(data: Any) -> bytes:
    return json.dumps(data, ensure_ascii=False, separators=(",", ":")).encode()


class TraceWriter:
    """Writes a trace as the run goes; a context manager. Each full chunk is written before the next begins.

    Raises:
        TraceError: the file cannot be made or written.
    """

    def __init__(self, path: Path, header: TraceHeader) -> None:
        self.path = path
        self._encoder = Encoder(len(header.columns), len(header.agents))
        self._outcome: dict[str, Any] = {}
        text = _json(header.to_json())
        try:
            self._file: BinaryIO = path.open("wb")
            self._file.write(MAGIC + _HEAD.pack(VERSION, len(text), zlib.crc32(text)) + text)
            self._file.flush()
        except OSError as error:
            raise TraceError(f"the trace {path.name} cannot be written: {error.strerror}") from error

    def record(self, record: TickRecord) -> None:
        """Takes one tick; ticks must grow."""
        self._encoder.add(record)
        if self._encoder.records >= CHUNK_RECORDS:
            self._write_chunk()

    def _write_chunk(self) -> None:
        encoder = self._encoder
        if encoder.records == 0:
            return
        first, last, records = encoder.first_tick, encoder.last_tick, encoder.records
        raw = encoder.take()
        packed = zlib.compress(raw, 6)
        head = _CHUNK.pack(_CHUNK_MARK, first, last, records, len(raw), len(packed), zlib.crc32(packed))
        self._write(head + packed)

    def _write(self, data: bytes) -> None:
        try:
            self._file.write(data)
            self._file.flush()
        except OSError as error:
            raise TraceError(f"the trace {self.path.name} cannot be written: {error.strerror}") from error

    def finish(self, outcome: dict[str, Any]) -> None:
        """Says how the run ended; `close` writes it last."""
        self._outcome = outcome

    def close(self) -> None:
        """Writes what is left and closes the file; again does nothing."""
        if self._file.closed:
            return
        try:
            self._write_chunk()
            text = _json(self._outcome)
            self._write(_END.pack(_END_MARK, len(text), zlib.crc32(text)) + text)
        finally:
            self._file.close()

    def __enter__(self) -> TraceWriter:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()


@dataclass(frozen=True)
class _Chunk:
    """Where a chunk's packed bytes are, and which ticks it holds."""

    offset: int
    first_tick: int
    last_tick: int
    records: int
    raw_bytes: int
    packed_bytes: int
    crc: int


class TraceReader:
    """Reads a trace: iterate over it, or `seek` a tick. `cut` says that the file ends before its run did.

    Raises:
        TraceError: there is no such file, it is no trace, of another version, or damaged.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        self.cut = True
        self.outcome: dict[str, Any] = {}
        try:
            self._file = path.open("rb")
        except OSError as error:
            raise TraceError(f"the trace {path.name} cannot be read: {error.strerror}") from error
        try:
            self.header = self._read_header()
            self._chunks = list(self._scan())
        except BaseException:
            self._file.close()
            raise
        self._firsts = [chunk.first_tick for chunk in self._chunks]

    def _damaged(self, what: str) -> TraceError:
        return TraceError(f"the trace {self.path.name} is damaged: {what}")

    def _read_header(self) -> TraceHeader:
        if self._file.read(len(MAGIC)) != MAGIC:
            raise TraceError(
                f"{self.path.name} is not a KitRobot trace", "A trace is what `kitrobot run --trace` writes."
            )
        head = self._file.read(_HEAD.size)
        if len(head) < _HEAD.size:
            raise self._damaged("it ends in its header")
        version, length, crc = _HEAD.unpack(head)
        if version != VERSION:
            raise TraceError(
                f"the trace {self.path.name} has format version {version}, and this KitRobot reads version {VERSION}",
                "Open it with the KitRobot that wrote it, or a newer one.",
            )
        text = self._file.read(length) if length <= MAX_HEADER_BYTES else b""
        if len(text) < length or zlib.crc32(text) != crc:
            raise self._damaged("its header is not what was written")
        return TraceHeader.from_json(json.loads(text))

    def _scan(self) -> Iterator[_Chunk]:
        size = self.path.stat().st_size
        offset = self._file.tell()
        last = -1
        while True:
            self._file.seek(offset)
            head = self._file.read(_CHUNK.size)
            if head[:4] == _END_MARK:
                self._read_outcome(head, offset)
                return
            if len(head) < _CHUNK.size:
                if not (_CHUNK_MARK.startswith(head[:4]) or _END_MARK.startswith(head[:4])):
                    raise self._damaged(f"byte {offset} begins neither a chunk nor the end")
                return
            mark, first, final, records, raw, packed, crc = _CHUNK.unpack(head)
            if mark != _CHUNK_MARK or raw > MAX_CHUNK_BYTES or not last < first <= final or records > final - first + 1:
                raise self._damaged(f"byte {offset} does not begin a chunk")
            offset += _CHUNK.size
            if offset + packed > size:
                return
            yield _Chunk(offset, first, final, records, raw, packed, crc)
            offset += packed
            last = final

    def _read_outcome(self, head: bytes, offset: int) -> None:
        if len(head) < _END.size:
            return
        _, length, crc = _END.unpack(head[: _END.size])
        if length > MAX_HEADER_BYTES:
            raise self._damaged("its end is not what was written")
        self._file.seek(offset + _END.size)
        text = self._file.read(length)
        if len(text) < length:
            return
        if zlib.crc32(text) != crc or self._file.read(1):
            raise self._damaged("its end is not what was written")
        self.outcome = json.loads(text)
        self.cut = False

    @property
    def first_tick(self) -> int:
        """The first tick there is; 0 in a trace without records."""
        return self._chunks[0].first_tick if self._chunks else 0

    @property
    def last_tick(self) -> int:
        """The last tick there is; -1 in a trace without records."""
        return self._chunks[-1].last_tick if self._chunks else -1

    def _records(self, chunk: _Chunk) -> Iterator[TickRecord]:
        self._file.seek(chunk.offset)
        packed = self._file.read(chunk.packed_bytes)
        if zlib.crc32(packed) != chunk.crc:
            raise self._damaged(
                f"what was written of ticks {chunk.first_tick} to {chunk.last_tick} is not there any more"
            )
        try:
            unpacker = zlib.decompressobj()
            raw = unpacker.decompress(packed, chunk.raw_bytes + 1)
        except zlib.error as error:
            raise self._damaged(f"ticks {chunk.first_tick} to {chunk.last_tick} cannot be unpacked") from error
        if len(raw) != chunk.raw_bytes:
            raise self._damaged(f"ticks {chunk.first_tick} to {chunk.last_tick} unpack to another length")
        return decode(raw, chunk.first_tick, chunk.records, len(self.header.columns), len(self.header.agents))

    def __iter__(self) -> Iterator[TickRecord]:
        for chunk in self._chunks:
            yield from self._records(chunk)

    def seek(self, tick: int) -> TickRecord:
        """The record of that tick, or the last one before it (the first of all, if there is none before)."""
        if not self._chunks:
            raise TraceError(f"the trace {self.path.name} holds no ticks")
        chunk = self._chunks[max(0, bisect_right(self._firsts, tick) - 1)]
        found: TickRecord | None = None
        for record in self._records(chunk):
            if found is not None and record.tick > tick:
                break
            found = record
        if found is None:
            raise self._damaged(f"the chunk of tick {tick} is empty")
        return found

    def close(self) -> None:
        """Closes the file."""
        self._file.close()

    def __enter__(self) -> TraceReader:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()
