"""The files that a command has read, so that none of its outputs overwrites one.

Code that opens a file named by a user records it here (`open_regular`, or `note_read`); code that writes one checks it
(`expect_output`). A file is identified by its place on the disk, so links and other spellings of its name lead to the
same one. Records exist only while `recording_reads` is open: the studio reads and writes the same files all day.
"""

from __future__ import annotations

import contextlib
import os
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.text.sentences import Sentence

Identity = tuple[int, int]
"""Device and number of a file on it."""


class OutputPlaceError(KitRobotError):
    """An output would be written over a file that is read, or over another output."""


@dataclass
class _Record:
    identities: set[Identity] = field(default_factory=set)
    paths: set[str] = field(default_factory=set)
    """The same by their real paths: a file may be replaced after it was read."""


_records: list[_Record] = []


@contextlib.contextmanager
def recording_reads() -> Iterator[None]:
    """A context in which it is known what is read, by whatever thread."""
    record = _Record()
    _records.append(record)
    try:
        yield
    finally:
        _records.remove(record)


def note_read(path: Path, handle: int | None = None) -> None:
    """Says that a file is read. `handle`: where it is open already."""
    if not _records:
        return
    with contextlib.suppress(OSError, ValueError):
        state = os.stat(path) if handle is None else os.fstat(handle)
        real = os.path.realpath(path)
        for record in _records:
            record.identities.add((state.st_dev, state.st_ino))
            record.paths.add(real)


def expect_output(path: Path, *inputs: Path | None) -> None:
    """That an output may be written to a path.

    Args:
        path: where; there need be no file.
        inputs: files that are read besides those that were noted.

    Raises:
        OutputPlaceError: it is a file that was read.
    """
    record = _Record()
    for one in inputs:
        if one is not None:
            with contextlib.suppress(OSError, ValueError):
                record.paths.add(os.path.realpath(one))
                state = os.stat(one)
                record.identities.add((state.st_dev, state.st_ino))
    if any(_is_in(one, path) for one in (record, *_records)):
        raise OutputPlaceError(
            Sentence("`{path}` would be written over, and it is a file that is read", path),
            Sentence("give the output a name of its own"),
        )


def expect_outputs(*paths: Path | None) -> None:
    """That outputs may be written to these paths, each to another file; None: that one is not wanted.

    Raises:
        OutputPlaceError: one is a file that was read, or two are one file.
    """
    record = _Record()
    for path in paths:
        if path is None:
            continue
        expect_output(path)
        if _is_in(record, path):
            raise OutputPlaceError(
                Sentence("two outputs would be written to `{path}`", path), Sentence("give each a name of its own")
            )
        with contextlib.suppress(OSError, ValueError):
            record.paths.add(os.path.realpath(path))
            state = os.stat(path)
            record.identities.add((state.st_dev, state.st_ino))


def _is_in(record: _Record, path: Path) -> bool:
    try:
        if os.path.realpath(path) in record.paths:
            return True
        state = os.stat(path)
    except (OSError, ValueError):
        return False
    return (state.st_dev, state.st_ino) in record.identities
