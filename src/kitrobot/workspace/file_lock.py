"""A lock between processes that nobody has to clean up after: it ends with the process that took it.

The system keeps it on an open file, `path`, which holds nothing. Left to others: who may take which.
"""

from __future__ import annotations

import contextlib
import os
import sys
from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class FileLock:
    """A lock that is held."""

    path: Path
    handle: int

    @staticmethod
    def take(path: Path) -> FileLock | None:
        """The lock, or None when somebody has it, in this process or another.

        Raises:
            OSError: the file cannot be made.
        """
        handle = os.open(path, os.O_RDWR | os.O_CREAT | getattr(os, "O_CLOEXEC", 0), 0o600)
        if _lock(handle):
            return FileLock(path, handle)
        os.close(handle)
        return None

    @staticmethod
    def is_taken(path: Path) -> bool:
        """Whether somebody has the lock now."""
        if not path.exists():
            return False
        try:
            lock = FileLock.take(path)
        except OSError:
            return False
        if lock is None:
            return True
        os.close(lock.handle)
        return False

    def release(self) -> None:
        """Gives it back."""
        with contextlib.suppress(OSError):
            os.close(self.handle)
        with contextlib.suppress(OSError):
            self.path.unlink()


def _lock(handle: int) -> bool:
    try:
        if sys.platform == "win32":
            import msvcrt

            msvcrt.locking(handle, msvcrt.LK_NBLCK, 1)
        else:
            import fcntl

            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        return False
    return True
