"""One journal file: the changes to one open mission, kept for recovery after a crash.

A file is a line that names the format, then frames: length and CRC-32 of a payload (both 32 bits, big endian), then
the payload, which is JSON compressed by zlib. The first frame says whose journal it is, each other frame holds one
record with its number from 0 and whether the mission was unsaved after it, and says once more whose journal it is.
Records are texts that only the page understands. Frames are only ever appended, or the whole file is replaced at once.

Whatever becomes of the bytes, each frame that is whole is read: behind a damage the next one is looked for, and its
number tells how many were lost. Nothing is written that would be too large to be read. Left to others: which journal
belongs to whom (recovery), what a record means (the page), which records depend on others (the page).
"""

from __future__ import annotations

import contextlib
import json
import os
import struct
import zlib
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.files.disk import FileError, read_bytes, write_atomic
from kitrobot.files.folder_quota import expect_room_for_more
from kitrobot.text.sentences import Sentence, Word

FORMAT = b"kitrobot journal 1\n"
_ANY_FORMAT = b"kitrobot journal "
_FRAME = struct.Struct(">II")
_VERSION = 1
LARGEST_RECORD_BYTES = 32 * 1024 * 1024
"""Of one record's JSON, before it is compressed: written and read. More than any request of the page can bring."""
LARGEST_JOURNAL_BYTES = 48 * 1024 * 1024
"""Of a journal's file."""
_MOST_TRIED = 16
"""Times the file's length: the bytes whose checksums are worked out at most to find frames behind a damage."""
_PAYLOAD_BEGINS = zlib.compress(b"", 1)[:2]


class JournalError(KitRobotError):
    """A journal cannot be used."""


@dataclass(frozen=True)
class Journal:
    """What a journal's file holds.

    `path` is the mission that it is about ("" for one without a file), `name` what people call it. A record that was
    lost is "". `unsaved`: whether its last state was not on disk. `cut`: there are bytes that are no whole frame,
    `damaged`: and that were not merely cut off at the end.
    """

    path: str
    name: str
    records: tuple[str, ...]
    unsaved: bool
    cut: bool = False
    damaged: bool = False


def read_journal(file: Path) -> Journal | None:
    """What is whole of a journal; None when nothing is.

    Raises:
        JournalError: it was written by a later KitRobot.
        FileError: it cannot be read.
    """
    data = read_bytes(file)
    begins = data.startswith(FORMAT)
    frames, rest, gaps = _frames(data, len(FORMAT) if begins else 0)
    later = not begins and data.startswith(_ANY_FORMAT) and b"\n" in data[:40]
    if later and not any(frame.get("format") == _VERSION for frame in frames):
        raise JournalError(
            Sentence("this journal was written by a later KitRobot"), Sentence("open the mission with that one")
        )
    head = next((one for one in frames if isinstance(one.get("path"), str) and isinstance(one.get("name"), str)), None)
    if head is None and not any("record" in frame for frame in frames):
        return None
    records: list[str] = []
    unsaved = False
    damaged = gaps or not begins
    for frame in frames:
        if frame.get("record") is None and frame is head:
            continue
        record, number = frame.get("record"), frame.get("number")
        if not isinstance(record, str) or not isinstance(number, int) or not len(records) <= number <= len(data):
            damaged = True
            continue
        damaged |= number > len(records)
        records += [""] * (number - len(records)) + [record]
        unsaved = frame.get("unsaved") is True
    damaged |= _is_more_than_cut(rest)
    path, name = (head["path"], head["name"]) if head is not None else ("", "")
    return Journal(path, name, tuple(records), unsaved, bool(rest) or damaged, damaged)


def write_journal(file: Path, journal: Journal) -> int:
    """Puts a whole journal in the file's place; gives its length in bytes.

    Raises:
        JournalError: it is too large.
        FileError: it cannot be written; the old one is still there.
    """
    head = _frame({"format": _VERSION, "path": journal.path, "name": journal.name})
    data = FORMAT + head + _record_frames(journal.records, 0, journal)
    _expect_room(len(data))
    write_atomic(file, data)
    return len(data)


def append_records(file: Path, first: int, more: Journal) -> int:
    """Writes records behind the others and makes sure they are on the disk; gives the file's length in bytes.

    Args:
        file: a journal that is whole.
        first: the number of the first of the records.
        more: the records, whose they are, and whether the mission is unsaved after them.

    Raises:
        JournalError: they are too large, or the journal would be; nothing was written.
        FileError: they cannot be written; the journal is as it was.
    """
    data = _record_frames(more.records, first, more)
    try:
        with file.open("r+b", buffering=0) as stream:
            before = stream.seek(0, os.SEEK_END)
            _expect_room(before + len(data))
            expect_room_for_more(len(data))
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
        reason = Word((error.strerror or str(error)).lower())
        raise FileError(
            Sentence("the journal could not be written: {reason}", reason), Sentence("save your work"), path=file
        ) from None


def _record_frames(records: Iterable[str], first: int, journal: Journal) -> bytes:
    whose = {"format": _VERSION, "path": journal.path, "name": journal.name, "unsaved": journal.unsaved}
    return b"".join(_frame({**whose, "number": number, "record": one}) for number, one in enumerate(records, first))


def _frame(content: dict[str, Any]) -> bytes:
    # What came as half a pair of UTF-16 goes back as it came.
    text = json.dumps(content, ensure_ascii=False).encode("utf-8", "surrogatepass")
    if len(text) > LARGEST_RECORD_BYTES:
        limit = LARGEST_RECORD_BYTES // (1024 * 1024)
        raise JournalError(
            Sentence("this change is too large for the journal, which takes {limit} MB", limit),
            Sentence("save the mission"),
        )
    payload = zlib.compress(text, 1)
    return _FRAME.pack(len(payload), zlib.crc32(payload)) + payload


def _expect_room(length: int) -> None:
    if length > LARGEST_JOURNAL_BYTES:
        limit = LARGEST_JOURNAL_BYTES // (1024 * 1024)
        raise JournalError(Sentence("the journal is full: it takes {limit} MB", limit), Sentence("save the mission"))


def _frames(data: bytes, at: int) -> tuple[list[dict[str, Any]], bytes, bool]:
    """The frames that are whole, the bytes behind the last of them, and whether bytes between them are none."""
    found: list[dict[str, Any]] = []
    gaps = False
    left = _MOST_TRIED * len(data)
    while True:
        frame = _frame_at(data, at)
        if frame is not None:
            found.append(frame[0])
            at = frame[1]
            continue
        begin, there = at + 1, None
        while left > 0 and there is None:
            # Where a payload may begin; the frame's head is before it.
            begin = data.find(_PAYLOAD_BEGINS, begin + _FRAME.size) - _FRAME.size
            if begin < 0:
                break
            left -= _FRAME.size + min(_FRAME.unpack_from(data, begin)[0], len(data) - begin)
            there = _frame_at(data, begin)
            begin += there is None
        if there is None:
            return found, data[at:], gaps
        gaps, at = True, begin


def _frame_at(data: bytes, at: int) -> tuple[dict[str, Any], int] | None:
    """The whole frame that begins there, and where it ends."""
    if at + _FRAME.size > len(data):
        return None
    length, checksum = _FRAME.unpack_from(data, at)
    end = at + _FRAME.size + length
    payload = memoryview(data)[at + _FRAME.size : end]
    if end > len(data) or zlib.crc32(payload) != checksum:
        return None
    content = _content(bytes(payload))
    return None if content is None else (content, end)


def _content(payload: bytes) -> dict[str, Any] | None:
    opener = zlib.decompressobj()
    try:
        content = json.loads(opener.decompress(payload, LARGEST_RECORD_BYTES))
    except (zlib.error, ValueError, RecursionError):
        return None
    return content if isinstance(content, dict) else None


def _is_more_than_cut(rest: bytes) -> bool:
    """Whether these last bytes are something else than a frame that was not written to its end."""
    if len(rest) < _FRAME.size:
        return False
    length, _ = _FRAME.unpack_from(rest)
    return bool(len(rest) >= _FRAME.size + length or length > LARGEST_RECORD_BYTES)
