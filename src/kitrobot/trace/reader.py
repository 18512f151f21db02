"""Reading a `.krtrace`: its header at once, any record when it is asked for.

Opening hops over the heads of the chunks and unpacks nothing but the events. A file may come from anywhere: every
length is held against a bound before anything of that length is read or unpacked, and whatever does not fit ends in a
`TraceError`.
"""

from __future__ import annotations

import json
import zlib
from bisect import bisect_right
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import cached_property, lru_cache
from pathlib import Path
from types import TracebackType
from typing import Any, NamedTuple

from kitrobot.diagnostics.regular import open_regular
from kitrobot.text.sentences import Recorded, Sentence, Word
from kitrobot.trace import layout
from kitrobot.trace.codec import decode, decode_events
from kitrobot.trace.header import header_from_json
from kitrobot.trace.model import TickRecord, TraceError, TraceEvent, TraceHeader

MOST_EVENTS = 100_000
"""Events that are kept of a trace: those that happened last."""


class _CompressedChunk(NamedTuple):
    """A stretch of the file that zlib packed."""

    offset: int
    raw_bytes: int
    packed_bytes: int
    crc: int


class _Chunk(NamedTuple):
    """Which ticks a chunk holds, and where."""

    first_tick: int
    last_tick: int
    records: int
    body: _CompressedChunk
    events: _CompressedChunk

    @property
    def ticks(self) -> Sentence:
        return Sentence("ticks {first} to {last}", self.first_tick, self.last_tick)


class TraceReader:
    """Reads a trace: iterate over it, `walk` on from a tick, or `seek` one. `cut` says that the file ends before its
    run did; `outcome` is how the run ended, empty in a file that was cut.

    Raises:
        TraceError: there is no such file, it is no trace, of another version, or damaged.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        self.cut = True
        self.outcome: dict[str, Any] = {}
        try:
            self._file = open_regular(path)
        except (OSError, ValueError) as error:
            reason = Word(error.strerror if isinstance(error, OSError) else error)
            raise TraceError(Sentence("the trace {path} cannot be read: {reason}", path.name, reason)) from error
        try:
            self.header: TraceHeader = self._read_header()
            self._chunks = list(self._scan())
        except OSError as error:
            self._file.close()
            raise TraceError(
                Sentence("the trace {path} cannot be read: {reason}", path.name, Word(error.strerror))
            ) from error
        except BaseException:
            self._file.close()
            raise
        self._firsts = [chunk.first_tick for chunk in self._chunks]
        # Events of a run say few different things.
        self._recorded = lru_cache(1000)(Recorded)

    def _damaged(self, what: str) -> TraceError:
        return TraceError(Sentence("the trace {path} is damaged: {what}", self.path.name, what))

    # -- the file

    def _read_header(self) -> TraceHeader:
        if self._file.read(len(layout.MAGIC)) != layout.MAGIC:
            raise TraceError(
                Sentence("{path} is not a KitRobot trace", self.path.name),
                Sentence("a trace is what `kitrobot run --trace` writes"),
            )
        start = self._file.read(layout.VERSION_HEAD.size)
        if len(start) < layout.VERSION_HEAD.size:
            raise self._damaged(Sentence("it ends in its header"))
        self._check_version(*layout.VERSION_HEAD.unpack(start))
        head = self._file.read(layout.HEAD.size)
        if len(head) < layout.HEAD.size:
            raise self._damaged(Sentence("it ends in its header"))
        raw, packed, crc = layout.HEAD.unpack(head)
        if raw > layout.MOST_HEADER_BYTES or packed > layout.MOST_HEADER_BYTES:
            raise self._damaged(Sentence("its header is not what was written"))
        text = self._unpacked(_CompressedChunk(self._file.tell(), raw, packed, crc), lambda: Sentence("its header"))
        # A list of nothing is two bytes in a file and many in memory.
        if text.count(b"[") + text.count(b"{") > layout.MOST_HEADER_LISTS:
            raise self._damaged(Sentence("its header is not what was written"))
        return header_from_json(self._plain(text, Sentence("its header")))

    def _check_version(self, version: int) -> None:
        if version == layout.VERSION:
            return
        name = self.path.name
        if version < layout.VERSION:
            raise TraceError(
                Sentence(
                    "the trace {path} is of an older KitRobot (format {version}), which did not keep the mission",
                    name,
                    version,
                ),
                Sentence("record the run once more: the same mission and seed give the same run"),
            )
        raise TraceError(
            Sentence(
                "the trace {path} has format {found}, and this KitRobot reads format {wanted}",
                name,
                version,
                layout.VERSION,
            ),
            Sentence("open it with the KitRobot that wrote it, or a newer one"),
        )

    def _plain(self, text: bytes, what: str) -> Any:
        try:
            return json.loads(text)
        except (ValueError, RecursionError) as error:
            raise self._damaged(Sentence("{what} is not what was written", what)) from error

    def _scan(self) -> Iterator[_Chunk]:
        size = self.path.stat().st_size
        offset = self._file.tell()
        last, count = -1, 0
        while True:
            self._file.seek(offset)
            head = self._file.read(layout.CHUNK.size)
            if head[:4] == layout.END_MARK:
                self._read_outcome(head, offset)
                return
            if len(head) < layout.CHUNK.size:
                if not (layout.CHUNK_MARK.startswith(head[:4]) or layout.END_MARK.startswith(head[:4])):
                    raise self._damaged(Sentence("byte {offset} begins neither a chunk nor the end", offset))
                return
            chunk = self._chunk(head, offset, last)
            count += 1
            if count > layout.MOST_CHUNKS:
                raise self._damaged(Sentence("it has more parts than any run"))
            offset = chunk.events.offset + chunk.events.packed_bytes
            if offset > size:
                return
            yield chunk
            last = chunk.last_tick

    def _chunk(self, head: bytes, offset: int, last: int) -> _Chunk:
        mark, first, final, records, *rest = layout.CHUNK.unpack(head)
        raw, packed, crc, events_raw, events_packed, events_crc, check = rest
        whole = mark == layout.CHUNK_MARK and check == zlib.crc32(head[:-4])
        sensible = last < first <= final and 0 < records <= min(layout.CHUNK_RECORDS, final - first + 1)
        if not whole or not sensible or max(raw, packed, events_raw, events_packed) > layout.MOST_CHUNK_BYTES:
            raise self._damaged(Sentence("byte {offset} does not begin a chunk", offset))
        at = offset + layout.CHUNK.size
        body = _CompressedChunk(at, raw, packed, crc)
        return _Chunk(first, final, records, body, _CompressedChunk(at + packed, events_raw, events_packed, events_crc))

    def _read_outcome(self, head: bytes, offset: int) -> None:
        if len(head) < layout.END.size:
            return
        _, length, crc = layout.END.unpack(head[: layout.END.size])
        if length > layout.MOST_OUTCOME_BYTES:
            raise self._damaged(Sentence("its end is not what was written"))
        self._file.seek(offset + layout.END.size)
        text = self._file.read(length)
        if len(text) < length:
            return
        if zlib.crc32(text) != crc or self._file.read(1):
            raise self._damaged(Sentence("its end is not what was written"))
        outcome = self._plain(text, Sentence("its end"))
        if not isinstance(outcome, dict):
            raise self._damaged(Sentence("its end is not what was written"))
        self.outcome = outcome
        self.cut = False

    def _unpacked(self, packed: _CompressedChunk, what: Callable[[], Sentence]) -> bytes:
        """A packed stretch of the file, never more than it says; `what` is its name in a sentence."""
        self._file.seek(packed.offset)
        data = self._file.read(packed.packed_bytes)
        if len(data) < packed.packed_bytes or zlib.crc32(data) != packed.crc:
            raise self._damaged(Sentence("{what} is not there as it was written", what()))
        try:
            raw = zlib.decompressobj().decompress(data, packed.raw_bytes + 1)
        except zlib.error as error:
            raise self._damaged(Sentence("{what} cannot be unpacked", what())) from error
        if len(raw) != packed.raw_bytes:
            raise self._damaged(Sentence("{what} unpacks to another length", what()))
        return raw

    # -- what is in it

    @property
    def first_tick(self) -> int:
        """The first tick there is; 0 in a trace without records."""
        return self._chunks[0].first_tick if self._chunks else 0

    @property
    def last_tick(self) -> int:
        """The last tick there is; -1 in a trace without records."""
        return self._chunks[-1].last_tick if self._chunks else -1

    @cached_property
    def events(self) -> list[tuple[int, TraceEvent]]:
        """(tick of its record, event) of everything that happened, in order; of very many the last ones.

        Raises:
            TraceError: the file is damaged.
        """
        found: list[tuple[int, TraceEvent]] = []
        for chunk in self._chunks:
            found += self._events_of(chunk)
            if len(found) > 2 * MOST_EVENTS:
                del found[:-MOST_EVENTS]
        return found[-MOST_EVENTS:]

    def _events_of(self, chunk: _Chunk) -> Iterator[tuple[int, TraceEvent]]:
        data = self._unpacked(chunk.events, lambda: Sentence("what happened in {ticks}", chunk.ticks))
        return decode_events(data, chunk.first_tick, chunk.last_tick, len(self.header.agents), self._recorded)

    def _records(self, chunk: _Chunk) -> Iterator[TickRecord]:
        header = self.header
        events: dict[int, list[TraceEvent]] = {}
        for tick, event in self._events_of(chunk):
            events.setdefault(tick, []).append(event)
        data = self._unpacked(chunk.body, lambda: chunk.ticks)
        made = 0
        for record in decode(data, chunk.first_tick, chunk.records, len(header.columns), len(header.agents)):
            made = record.tick
            if made > chunk.last_tick:
                break
            record.events = events.get(record.tick, [])
            yield record
        if made != chunk.last_tick:
            raise self._damaged(Sentence("{ticks} are not the ticks that are in it", chunk.ticks))

    def __iter__(self) -> Iterator[TickRecord]:
        for chunk in self._chunks:
            for record in self._records(chunk):
                yield kept(record)

    def walk(self, tick: int) -> Iterator[TickRecord]:
        """The records from that tick on; each holds only until the next one is asked for (see `kept`)."""
        for chunk in self._chunks[max(0, bisect_right(self._firsts, tick) - 1) :]:
            for record in self._records(chunk):
                if record.tick >= tick:
                    yield record

    def walk_back(self, tick: int) -> Iterator[TickRecord]:
        """The records before that tick, the nearest one first."""
        for chunk in reversed(self._chunks[: bisect_right(self._firsts, tick - 1)]):
            yield from reversed([kept(record) for record in self._records(chunk) if record.tick < tick])

    def seek(self, tick: int) -> TickRecord:
        """The record of that tick, or the last one before it (the first of all, if there is none before)."""
        if not self._chunks:
            raise TraceError(Sentence("the trace {path} holds no ticks", self.path.name))
        chunk = self._chunks[max(0, bisect_right(self._firsts, tick) - 1)]
        wanted = min(max(tick, chunk.first_tick), chunk.last_tick)
        dense = chunk.records == chunk.last_tick - chunk.first_tick + 1
        found: TickRecord | None = None
        for record in self._records(chunk):
            if record.tick > wanted:
                break
            # Where no tick is missing only the last one has to be kept.
            found = record if dense else kept(record)
            if record.tick == wanted:
                break
        assert found is not None, "a chunk has records"
        return kept(found)

    def close(self) -> None:
        """Closes the file."""
        self._file.close()

    def __enter__(self) -> TraceReader:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()


def kept(record: TickRecord) -> TickRecord:
    """The same record, to be kept: its lists are its own."""
    return replace(record, numbers=list(record.numbers), active=list(record.active))
