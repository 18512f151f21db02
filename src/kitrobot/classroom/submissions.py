"""The files of one pupil: handed in, listed, read, within a quota; nothing outside of the folder can be named."""

from __future__ import annotations

import contextlib
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from kitrobot.classroom.names import ENDING, free_name, key_of, work_name
from kitrobot.classroom.pupil_status import HandIn
from kitrobot.files.disk import FileError, read_bytes, write_atomic
from kitrobot.files.folder import revision_of
from kitrobot.files.folder_quota import QuotaError
from kitrobot.files.listing import utc_moment
from kitrobot.text.sentences import Sentence

MOST_FILES: Final = 100
MOST_BYTES: Final = 16 * 1024 * 1024
"""Of all files of one pupil."""
LARGEST_BYTES: Final = 1024 * 1024
"""Of one of them: what can be graded."""


@dataclass(frozen=True)
class Submission:
    """A file that was handed in; `modified` is a moment in UTC, `exercise` the one that it is the work for, or ""."""

    name: str
    bytes: int
    modified: str
    exercise: str = ""


def list_submissions(folder: Path) -> list[Submission]:
    """What is in the folder, the newest first."""
    found = []
    with contextlib.suppress(OSError):
        for path in folder.iterdir():
            with contextlib.suppress(OSError):
                if path.suffix.lower() == ENDING and not path.name.startswith(".") and path.is_file():
                    state = path.stat()
                    found.append((state.st_mtime, Submission(path.name, state.st_size, utc_moment(state.st_mtime))))
    return [work for _, work in sorted(found, key=lambda one: (-one[0], one[1].name))]


def read_submission(folder: Path, name: str) -> tuple[bytes, str]:
    """The bytes of a file of the folder, and their revision.

    Raises:
        FileError: there is none of that name.
    """
    known = {one.name for one in list_submissions(folder)}
    if name not in known:
        raise FileError(
            Sentence("there is no file `{name}` in this folder", name[:80]),
            Sentence("it may have another name now"),
            path=Path(name[:80].replace("\0", "")),
        )
    data = read_bytes(folder / name)
    return data, revision_of(data)


def store_submission(folder: Path, shown: str, data: bytes, base: str) -> HandIn:
    """Puts a mission into the folder: in the place of the file that it goes on from, else beside it.

    Args:
        folder: the pupil's; one after the other.
        shown: the name that the page shows.
        data: the whole file.
        base: the revision that the page handed in before under that name, "" when it begins anew.

    Raises:
        QuotaError: the folder is full.
        FileError: it cannot be written; what was there is there.
    """
    if len(data) > LARGEST_BYTES:
        raise QuotaError(
            Sentence("this mission is larger than the {most} kB that a class takes", LARGEST_BYTES // 1024),
            Sentence("make it smaller; it is still in your studio"),
        )
    folder.mkdir(exist_ok=True)
    there = {one.name: one.bytes for one in list_submissions(folder)}
    name = _place(folder, work_name(shown), there, data, base)
    before = there.get(name)
    if before is None and len(there) >= MOST_FILES:
        raise _full(Sentence("the folder has {most} files already", MOST_FILES))
    if sum(there.values()) - (before or 0) + len(data) > MOST_BYTES:
        raise _full(Sentence("the folder has {most} MB already", MOST_BYTES // (1024 * 1024)))
    write_atomic(folder / name, data)
    return HandIn(name, revision_of(data))


def _place(folder: Path, stem: str, there: dict[str, int], data: bytes, base: str) -> str:
    """The name of the file: the wished one where that goes on from `base`, is the same, or is free."""
    alike = next((name for name in there if key_of(name) == key_of(stem + ENDING)), None)
    if alike is None:
        return stem + ENDING
    with contextlib.suppress(FileError):
        now = read_bytes(folder / alike)
        if now == data or revision_of(now) == base:
            return alike
    return free_name(stem, [name[: -len(ENDING)] for name in there]) + ENDING


def _full(why: Sentence) -> QuotaError:
    return QuotaError(why, Sentence("ask your teacher to make room; your work is kept here"))
