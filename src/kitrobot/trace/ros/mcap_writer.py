"""Writes MCAP files: chunks of messages, compressed with zstd, with every index that the format has.

A message costs one call of `struct` and two appends; the package `mcap` makes an object of each. Its reader, and that
of `rosbags`, read these files in tests. Source: https://mcap.dev/spec, version 0.
"""

from __future__ import annotations

import struct
import zlib
from collections.abc import Callable, Iterable, Mapping
from io import BytesIO
from typing import Final

from kitrobot.trace.ros.cdr import ENCAPSULATION

MAGIC: Final = b"\x89MCAP0\r\n"
CHUNK_BYTES: Final = 1 << 20
"""Of the messages of a chunk before it is compressed: about that many."""

_HEADER, _FOOTER, _SCHEMA, _CHANNEL, _MESSAGE, _CHUNK, _MESSAGE_INDEX, _CHUNK_INDEX = range(1, 9)
_ATTACHMENT, _ATTACHMENT_INDEX, _STATISTICS, _METADATA, _METADATA_INDEX, _SUMMARY_OFFSET, _DATA_END = range(9, 16)

_MESSAGE_HEAD: Final = struct.Struct("<BQHIQQ")
"""Opcode, length, channel, number in the sequence (0: not known), time of the log and of the message."""
_NUMBER: Final = struct.Struct(f"{_MESSAGE_HEAD.format}4sd")
"""A message that is one float64, whole."""
_NUMBER_FIELDS: Final = _NUMBER.size - 9
_MESSAGE_FIELDS: Final = _MESSAGE_HEAD.size - 9


def _record(opcode: int, *parts: bytes) -> bytes:
    data = b"".join(parts)
    return struct.pack("<BQ", opcode, len(data)) + data


def _sized(data: bytes) -> bytes:
    return struct.pack("<I", len(data)) + data


def _text(text: str) -> bytes:
    return _sized(text.encode())


def _texts(entries: Mapping[str, str]) -> bytes:
    return _sized(b"".join(_text(key) + _text(value) for key, value in entries.items()))


class McapWriter:
    """One file, which `finish` gives; messages come in the order of their times, in nanoseconds.

    Args:
        profile: which conventions the file follows, such as `ros2`.
        library: who writes it.
        compress: makes of a chunk's bytes a frame of zstd.
    """

    def __init__(self, profile: str, library: str, compress: Callable[[bytes], bytes]) -> None:
        self._compress = compress
        self._file = BytesIO()
        self._file.write(MAGIC + _record(_HEADER, _text(profile), _text(library)))
        self._schemas: list[bytes] = []
        self._channels: list[bytes] = []
        self._counts: list[int] = []
        self._chunk_indexes: list[bytes] = []
        self._attachment_indexes: list[bytes] = []
        self._metadata_indexes: list[bytes] = []
        self._times: list[int] = []
        """The first and the last time of each chunk."""
        self._begin_chunk()

    def _begin_chunk(self) -> None:
        self._parts: list[bytes] = []
        self._size = 0
        self._index: list[list[int]] = [[] for _ in self._channels]
        """Of each channel the times and places of its messages in this chunk, by turns."""
        self._first = self._last = -1

    def add_schema(self, name: str, encoding: str, text: str) -> int:
        """Adds the definition of a type; gives its number."""
        number = len(self._schemas) + 1
        record = _record(_SCHEMA, struct.pack("<H", number), _text(name), _text(encoding), _text(text))
        self._schemas.append(record)
        self._append(record)
        return number

    def add_channel(self, topic: str, encoding: str, schema: int) -> int:
        """Adds a topic; gives its number."""
        number = len(self._channels) + 1
        record = _record(_CHANNEL, struct.pack("<HH", number, schema), _text(topic), _text(encoding), _texts({}))
        self._channels.append(record)
        self._counts.append(0)
        self._index.append([])
        self._append(record)
        return number

    def _append(self, record: bytes) -> None:
        self._parts.append(record)
        self._size += len(record)

    def add_message(self, channel: int, nanoseconds: int, data: bytes) -> None:
        """Adds a message; a chunk that is full is written before it."""
        size = self._size
        if size >= CHUNK_BYTES:
            self._end_chunk()
            size = 0
        length = _MESSAGE_FIELDS + len(data)
        self._parts += (_MESSAGE_HEAD.pack(_MESSAGE, length, channel, 0, nanoseconds, nanoseconds), data)
        self._index[channel - 1] += (nanoseconds, size)
        self._size = size + length + 9
        if self._first < 0:
            self._first = nanoseconds
        self._last = nanoseconds

    def add_numbers(self, nanoseconds: int, numbers: Iterable[tuple[int, float]]) -> None:
        """Adds messages that are a number in CDR, each with its channel: most of a recording are."""
        if self._size >= CHUNK_BYTES:
            self._end_chunk()
        # Names of its own: this is most of the time that a recording takes.
        pack, append, index, size = _NUMBER.pack, self._parts.append, self._index, self._size
        for channel, number in numbers:
            append(pack(_MESSAGE, _NUMBER_FIELDS, channel, 0, nanoseconds, nanoseconds, ENCAPSULATION, number))
            entries = index[channel - 1]
            entries.append(nanoseconds)
            entries.append(size)
            size += _NUMBER.size
        self._size = size
        if self._first < 0:
            self._first = nanoseconds
        self._last = nanoseconds

    def _end_chunk(self) -> None:
        if not self._parts:
            return
        raw = b"".join(self._parts)
        packed = self._compress(raw)
        # A chunk of schemas and channels alone has the time 0.
        times = (max(self._first, 0), max(self._last, 0))
        chunk = _record(
            _CHUNK,
            struct.pack("<QQQI", *times, len(raw), zlib.crc32(raw)),
            _text("zstd"),
            struct.pack("<Q", len(packed)),
            packed,
        )
        start = self._file.tell()
        self._file.write(chunk)
        places, indexes = [], self._file.tell()
        for number, entries in enumerate(self._index, 1):
            if entries:
                places.append(struct.pack("<HQ", number, self._file.tell()))
                data = struct.pack(f"<{len(entries)}Q", *entries)
                self._file.write(_record(_MESSAGE_INDEX, struct.pack("<H", number), _sized(data)))
                self._counts[number - 1] += len(entries) // 2
        if self._first >= 0:
            self._times += times
        self._chunk_indexes.append(
            _record(
                _CHUNK_INDEX,
                struct.pack("<QQQQ", *times, start, len(chunk)),
                _sized(b"".join(places)),
                struct.pack("<Q", self._file.tell() - indexes),
                _text("zstd"),
                struct.pack("<QQ", len(packed), len(raw)),
            )
        )
        self._begin_chunk()

    def add_attachment(self, name: str, media_type: str, data: bytes) -> None:
        """Adds a file, of the time 0."""
        self._end_chunk()
        start = self._file.tell()
        names = _text(name) + _text(media_type)
        fields = struct.pack("<QQ", 0, 0) + names + struct.pack("<Q", len(data)) + data
        record = _record(_ATTACHMENT, fields, struct.pack("<I", zlib.crc32(fields)))
        self._file.write(record)
        index = struct.pack("<QQQQQ", start, len(record), 0, 0, len(data))
        self._attachment_indexes.append(_record(_ATTACHMENT_INDEX, index, names))

    def add_metadata(self, name: str, entries: Mapping[str, str]) -> None:
        """Adds names with their values."""
        self._end_chunk()
        start = self._file.tell()
        record = _record(_METADATA, _text(name), _texts(entries))
        self._file.write(record)
        self._metadata_indexes.append(_record(_METADATA_INDEX, struct.pack("<QQ", start, len(record)), _text(name)))

    def finish(self) -> bytes:
        """Writes the summary; gives the file."""
        self._end_chunk()
        self._file.write(_record(_DATA_END, struct.pack("<I", 0)))
        start = self._file.tell()
        groups = [
            (_SCHEMA, self._schemas),
            (_CHANNEL, self._channels),
            (_STATISTICS, [self._statistics()]),
            (_CHUNK_INDEX, self._chunk_indexes),
            (_ATTACHMENT_INDEX, self._attachment_indexes),
            (_METADATA_INDEX, self._metadata_indexes),
        ]
        summary, offsets = b"", b""
        for opcode, records in groups:
            data = b"".join(records)
            offsets += _record(_SUMMARY_OFFSET, struct.pack("<BQQ", opcode, start + len(summary), len(data)))
            summary += data
        # The checksum counts the footer's own head and its two places too.
        fields = struct.pack("<BQQQ", _FOOTER, 20, start, start + len(summary))
        checksum = zlib.crc32(summary + offsets + fields)
        self._file.write(summary + offsets + fields + struct.pack("<I", checksum) + MAGIC)
        return self._file.getvalue()

    def _statistics(self) -> bytes:
        counts = b"".join(struct.pack("<HQ", number, count) for number, count in enumerate(self._counts, 1))
        kinds = (self._schemas, self._channels, self._attachment_indexes, self._metadata_indexes, self._chunk_indexes)
        return _record(
            _STATISTICS,
            struct.pack("<QHIIII", sum(self._counts), *map(len, kinds)),
            struct.pack("<QQ", min(self._times, default=0), max(self._times, default=0)),
            _sized(counts),
        )
