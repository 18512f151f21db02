"""Writes MCAP files: chunks of messages, compressed with zstd, with every index that the format has.

Messages of one length are added together, as rows of bytes; the package `mcap` makes an object of each message. Its
reader, and that of `rosbags`, read these files in tests. Source: https://mcap.dev/spec, version 0.
"""

from __future__ import annotations

import struct
import zlib
from collections.abc import Callable, Mapping
from io import BytesIO
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

MAGIC: Final = b"\x89MCAP0\r\n"

_HEADER, _FOOTER, _SCHEMA, _CHANNEL, _MESSAGE, _CHUNK, _MESSAGE_INDEX, _CHUNK_INDEX = range(1, 9)
_ATTACHMENT, _ATTACHMENT_INDEX, _STATISTICS, _METADATA, _METADATA_INDEX, _SUMMARY_OFFSET, _DATA_END = range(9, 16)

_HEAD: Final = struct.Struct("<BQHIQQ")
"""Of a message: opcode, length, channel, number in the sequence (0: not known), time of the log and of the message."""
_HEADS: Final = np.dtype(
    [("opcode", "u1"), ("length", "<u8"), ("channel", "<u2"), ("number", "<u4"), ("log", "<u8"), ("published", "<u8")]
)


def _record(opcode: int, *parts: bytes) -> bytes:
    data = b"".join(parts)
    return struct.pack("<BQ", opcode, len(data)) + data


def _sized(data: bytes) -> bytes:
    return struct.pack("<I", len(data)) + data


def _text(text: str) -> bytes:
    return _sized(text.encode())


def _texts(entries: Mapping[str, str]) -> bytes:
    return _sized(b"".join(_text(key) + _text(value) for key, value in entries.items()))


def _join_slices(data: bytes | bytearray, starts: NDArray[Any], sizes: NDArray[Any], order: NDArray[Any]) -> bytes:
    """The slices of `data` in that order; slices that stay neighbours are copied together."""
    firsts = order[np.diff(order, prepend=-2) != 1]
    lasts = order[np.diff(order, append=-2) != 1]
    view, ends = memoryview(data), starts + sizes
    pairs = zip(starts[firsts].tolist(), ends[lasts].tolist(), strict=True)
    return b"".join(view[start:end] for start, end in pairs)


class McapWriter:
    """One file, which `finish` gives; times are nanoseconds. A chunk has its messages in the order of their times.

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
        self._definitions = b""
        """Schemas and channels, which stand before the messages."""
        self._messages = bytearray()
        self._heads = bytearray()
        """Those of the messages once more."""

    def add_schema(self, name: str, encoding: str, text: str) -> int:
        """Adds the definition of a type; gives its number."""
        number = len(self._schemas) + 1
        record = _record(_SCHEMA, struct.pack("<H", number), _text(name), _text(encoding), _text(text))
        self._schemas.append(record)
        self._definitions += record
        return number

    def add_channel(self, topic: str, encoding: str, schema: int) -> int:
        """Adds a topic; gives its number."""
        number = len(self._channels) + 1
        record = _record(_CHANNEL, struct.pack("<HH", number, schema), _text(topic), _text(encoding), _texts({}))
        self._channels.append(record)
        self._counts.append(0)
        self._definitions += record
        return number

    def add_message(self, channel: int, nanoseconds: int, data: bytes) -> None:
        """Adds a message."""
        head = _HEAD.pack(_MESSAGE, _HEAD.size - 9 + len(data), channel, 0, nanoseconds, nanoseconds)
        self._heads += head
        self._messages += head + data

    def add_messages(self, channels: NDArray[Any] | int, nanoseconds: NDArray[Any], data: NDArray[np.uint8]) -> None:
        """Adds messages of one length.

        Args:
            channels: of each message its channel, or the one of all.
            nanoseconds: of each message its time.
            data: of each message its bytes, in a row.
        """
        messages = np.zeros(len(data), np.dtype([("head", _HEADS), ("data", "u1", data.shape[1:])]))
        head = messages["head"]
        head["opcode"], head["length"], head["channel"] = _MESSAGE, messages.itemsize - 9, channels
        head["log"] = head["published"] = nanoseconds
        messages["data"] = data
        self._heads += head.tobytes()
        self._messages += messages.tobytes()

    @property
    def chunk_bytes(self) -> int:
        """Of the messages since the last chunk."""
        return len(self._messages)

    def end_chunk(self) -> None:
        """Writes what was added as a chunk: messages that are added later have later times."""
        if not self._definitions and not self._heads:
            return
        heads = np.frombuffer(self._heads, _HEADS)
        order = np.argsort(heads["log"], kind="stable")
        sizes = heads["length"] + 9
        raw = self._definitions + _join_slices(self._messages, np.cumsum(sizes) - sizes, sizes, order)
        heads, sizes = heads[order], sizes[order]
        # A chunk of schemas and channels alone has the time 0.
        times = (int(heads["log"][0]), int(heads["log"][-1])) if len(heads) else (0, 0)
        packed = self._compress(raw)
        chunk = _record(
            _CHUNK,
            struct.pack("<QQQI", *times, len(raw), zlib.crc32(raw)),
            _text("zstd"),
            struct.pack("<Q", len(packed)),
            packed,
        )
        start = self._file.tell()
        self._file.write(chunk)
        placed = np.empty(len(heads), [("time", "<u8"), ("place", "<u8")])
        placed["time"], placed["place"] = heads["log"], len(self._definitions) + np.cumsum(sizes) - sizes
        order = np.argsort(heads["channel"], kind="stable")
        channels, firsts, counts = np.unique(heads["channel"][order], return_index=True, return_counts=True)
        offsets, indexes = [], self._file.tell()
        for channel, first, count in zip(channels.tolist(), firsts.tolist(), counts.tolist(), strict=True):
            offsets.append(struct.pack("<HQ", channel, self._file.tell()))
            data = placed[order[first : first + count]].tobytes()
            self._file.write(_record(_MESSAGE_INDEX, struct.pack("<H", channel), _sized(data)))
            self._counts[channel - 1] += count
        if len(heads):
            self._times += times
        self._chunk_indexes.append(
            _record(
                _CHUNK_INDEX,
                struct.pack("<QQQQ", *times, start, len(chunk)),
                _sized(b"".join(offsets)),
                struct.pack("<Q", self._file.tell() - indexes),
                _text("zstd"),
                struct.pack("<QQ", len(packed), len(raw)),
            )
        )
        self._begin_chunk()

    def add_attachment(self, name: str, media_type: str, data: bytes) -> None:
        """Adds a file, of the time 0."""
        self.end_chunk()
        start = self._file.tell()
        names = _text(name) + _text(media_type)
        fields = struct.pack("<QQ", 0, 0) + names + struct.pack("<Q", len(data)) + data
        record = _record(_ATTACHMENT, fields, struct.pack("<I", zlib.crc32(fields)))
        self._file.write(record)
        index = struct.pack("<QQQQQ", start, len(record), 0, 0, len(data))
        self._attachment_indexes.append(_record(_ATTACHMENT_INDEX, index, names))

    def add_metadata(self, name: str, entries: Mapping[str, str]) -> None:
        """Adds names with their values."""
        self.end_chunk()
        start = self._file.tell()
        record = _record(_METADATA, _text(name), _texts(entries))
        self._file.write(record)
        self._metadata_indexes.append(_record(_METADATA_INDEX, struct.pack("<QQ", start, len(record)), _text(name)))

    def finish(self) -> bytes:
        """Writes the summary; gives the file."""
        self.end_chunk()
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
