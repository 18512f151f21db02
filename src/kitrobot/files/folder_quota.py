"""How much somebody may write: everything that is written while a quota holds is counted before it is on the disk.

A quota holds for what is done within `writing_within`, in threads that are begun there too. What has been written is
measured once and counted on from there; it is measured anew before anything is refused, for files also go.
"""

from __future__ import annotations

import os
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from pathlib import Path

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.text.sentences import Sentence


class QuotaError(KitRobotError):
    """More than somebody may write; nothing of it was written."""


class Quota:
    """What may be in a folder: so many files and folders, of so many bytes. Safe to use from many threads."""

    def __init__(self, folder: Path, most_bytes: int, most_files: int) -> None:
        self._folder = folder
        self._most_bytes = most_bytes
        self._most_files = most_files
        self._lock = threading.Lock()
        self._taken: tuple[int, int] | None = None

    def take(self, size: int, files: int = 0) -> None:
        """So many bytes and files more are about to be written; less than none make room at the next measure.

        Raises:
            QuotaError: there is no room for them.
        """
        with self._lock:
            if self._taken is None or not self._fits(self._taken, size, files):
                self._taken = measured(self._folder)
            if (size > 0 or files > 0) and not self._fits(self._taken, size, files):
                raise QuotaError(
                    Sentence(
                        "there is no room left: this folder takes {files} files and {most} MB",
                        self._most_files,
                        self._most_bytes // (1024 * 1024),
                    ),
                    Sentence("ask your teacher to make room; what is on your screen is still there"),
                )
            self._taken = (self._taken[0] + max(0, size), self._taken[1] + max(0, files))

    def _fits(self, taken: tuple[int, int], size: int, files: int) -> bool:
        return taken[0] + size <= self._most_bytes and taken[1] + files <= self._most_files


def measured(folder: Path) -> tuple[int, int]:
    """Bytes, and files and folders, in a folder."""
    size = count = 0
    for place, folders, names in os.walk(folder):
        count += len(folders) + len(names)
        for name in names:
            try:
                size += os.lstat(os.path.join(place, name)).st_size
            except OSError:
                continue
    return size, count


_holds: ContextVar[Quota | None] = ContextVar("quota", default=None)


@contextmanager
def writing_within(quota: Quota) -> Iterator[None]:
    """What is written meanwhile is counted against the quota."""
    before = _holds.set(quota)
    try:
        yield
    finally:
        _holds.reset(before)


def expect_room(path: Path, size: int, *, keep_old: bool = False) -> None:
    """That a file may be written: `size` bytes in the place of what is there, or, with `keep_old`, beside it.

    Raises:
        QuotaError: there is no room for it.
    """
    quota = _holds.get()
    if quota is not None:
        gone = path.with_name(f"{path.name}~") if keep_old else path
        try:
            before, files = gone.lstat().st_size, 0
        except (OSError, ValueError):
            before, files = 0, 1
        quota.take(size - before, files)


def expect_room_for_more(size: int) -> None:
    """That a file may grow by so many bytes.

    Raises:
        QuotaError: there is no room for it.
    """
    quota = _holds.get()
    if quota is not None:
        quota.take(size)


def expect_room_for_folder(folder: Path) -> None:
    """That a folder may be made, and those above it, as far as they are not there.

    Raises:
        QuotaError: there is no room for it.
    """
    quota = _holds.get()
    missing = [] if quota is None else [one for one in (folder, *folder.parents) if not one.is_dir()]
    if quota is not None and missing:
        quota.take(0, len(missing))
