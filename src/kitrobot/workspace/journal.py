"""One journal on disk: what was done to one open mission, so that nothing is lost when everything dies.

A file is a line that names the format, then frames: length and CRC-32 of a payload (both 32 bits, big endian), then
the payload, which is JSON compressed by zlib. The first frame says whose journal it is, each other frame holds one
record with its number from 0 and whether the mission was unsaved after it. Records are texts that only the page
understands. Frames are only ever appended, or the whole file is replaced at once; so whatever a power cut leaves, the
frames before the first one that is not whole are exactly the first ones that were written. Left to others: which
journal belongs to whom (journals), what a record means (the page).
"""

from __future__ import annotations

import contextlib
import json
import os
import struct
import zlib
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from kitrobot.diagnostics import KitRobotError
from kitrobot.workspace.files import FileError, read_bytes, write_atomic

FORMAT = b"kitrobot journal 1\n"
_ANY_FORMAT = b"kitrobot journal "
_FRAME = struct.Struct(">II")
LARGEST_PAYLOAD_BYTES = 32 * 1024 * 1024


class JournalError(KitRobotError):
    """A journal cannot be used."""


@dataclass(frozen=True)
class Journal:
    """What a journal's file holds, as far as it is whole.

    `path` is the mission that it is about ("" for one without a file), `name` what people call it. `unsaved`: whether
    its last state was not on disk. `cut`: bytes follow that are no whole frame, `damaged`: and that were not merely
    cut off.
    """

    path: str
    name: str
    records: tuple[str, ...]
    unsaved: bool
    cut: bool = False
    damaged: bool = False


def read_journal(file: Path) -> Journal | None:
    """The whole part of a journal; None when not even its beginning is whole.

    Raises:
        JournalError: it was written by a later KitRobot.
        FileError: it cannot be read.
    """
    data = read_bytes(file)
    if data.startswith(_ANY_FORMAT) and b"\n" in data[:40] and not data.startswith(FORMAT):
        raise JournalError("this journal was written by a later KitRobot", "open the mission with that one")
    if not data.startswith(FORMAT):
        return None
    frames, rest = _frames(data[len(FORMAT) :])
    head = frames[0] if frames else {}
    path, name = head.get("path"), head.get("name")
    if not isinstance(path, str) or not isinstance(name, str):
        return None
    records: list[str] = []
    unsaved = False
    for frame in frames[1:]:
        record = frame.get("record")
        if frame.get("number") != len(records) or not isinstance(record, str):
            rest = b"\xff" * _FRAME.size
            break
        records.append(record)
        unsaved = frame.get("unsaved") is True
    return Journal(path, name, tuple(records), unsaved, bool(rest), _is_more_than_cut(rest))


def write_journal(file: Path, journal: Journal) -> int:
    """Puts a whole journal in the file's place; gives its length in bytes.

    Raises:
        FileError: it cannot be written; the old one is still there.
    """
    head = _frame({"path": journal.path, "name": journal.name})
    data = FORMAT + head + _record_frames(journal.records, 0, journal.unsaved)
    write_atomic(file, data)
    return len(data)


def append_records(file: Path, records: Sequence[str], first: int, unsaved: bool) -> int:
    """Writes records behind the others and makes sure they are on the disk; gives the file's length in bytes.

    Args:
        file: a journal that is whole.
        records: what to write.
        first: the number of the first of them.
        unsaved: whether the mission is unsaved after them.

    Raises:
        FileError: they cannot be written; the journal is as it was.
    """
    data = _record_frames(records, first, unsaved)
    try:
        with file.open("r+b", buffering=0) as stream:
            before = stream.seek(0, os.SEEK_END)
            try:
                view = memoryview(data)
                while view:
                    view = view[stream.write(view) :]
                os.fsync(stream.fileno())
            except OSError:
                with contextlib.suppress(OSError):
                    stream.truncate(before)
                raise
            return before + len(data)
    except OSError as error:
        reason = (error.strerror or str(error)).lower()
        raise FileError(f"the journal could not be written: {reason}", "save your work", path=file) from None


def _record_frames(records: Iterable[str], first: int, unsaved: bool) -> bytes:
    frames = [
        _frame({"number": number, "unsaved": unsaved, "record": record}) for number, record in enumerate(records, first)
    ]
    return b"".join(frames)


def _frame(content: dict[str, Any]) -> bytes:
    payload = zlib.compress(json.dumps(content).encode(), 1)
    return _FRAME.pack(len(payload), zlib.crc32(payload)) + payload


def _frames(data: bytes) -> tuple[list[dict[str, Any]], bytes]:
    """The frames up to the first that is not whole, and the bytes from there."""
    found: list[dict[str, Any]] = []
    at = 0
    while at + _FRAME.size <= len(data):
        length, checksum = _FRAME.unpack_from(data, at)
        payload = data[at + _FRAME.size : at + _FRAME.size + length]
        content = _content(payload) if len(payload) == length and zlib.crc32(payload) == checksum else None
        if content is None:
            break
        found.append(content)
        at += _FRAME.size + length
    return found, data[at:]


def _content(payload: bytes) -> dict[str, Any] | None:
    opener = zlib.decompressobj()
    try:
        content = json.loads(opener.decompress(payload, LARGEST_PAYLOAD_BYTES))
    except (zlib.error, ValueError, RecursionError):
        return None
    return content if isinstance(content, dict) else None


def _is_more_than_cut(rest: bytes) -> bool:
    """Whether these last bytes are something else than a frame that was not written to its end."""
    if len(rest) < _FRAME.size:
        return False
    length, _ = _FRAME.unpack_from(rest)
    return bool(len(rest) >= _FRAME.size + length or length > LARGEST_PAYLOAD_BYTES)
