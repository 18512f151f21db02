"""A lock between processes that nobody has to clean up after: it ends with the process that took it.

The system keeps it on an open file, `path`, which holds nothing and is removed when the lock is given back. Between
threads of one process it is a lock too. Left to others: who may take which.
"""

from __future__ import annotations

import contextlib
import os
import sys
import time
from dataclasses import dataclass
from pathlib import Path

from kitrobot.diagnostics.regular import lock_handle

_held: set[Path] | None = set() if sys.platform == "emscripten" else None
"""The locks of this process, where the system says yes to everybody (WebAssembly): no other process is there."""
_FIRST_PAUSE_S, _LONGEST_PAUSE_S = 0.001, 0.05


@dataclass(frozen=True)
class FileLock:
    """A lock that is held."""

    path: Path
    handle: int

    @staticmethod
    def take(path: Path) -> FileLock | None:
        """The lock, or None when somebody has it, in this process or another.

        Raises:
            OSError: the file cannot be made, or its file system has no locks.
        """
        while True:
            handle = os.open(path, os.O_RDWR | os.O_CREAT | getattr(os, "O_CLOEXEC", 0), 0o666)
            try:
                taken = lock_handle(handle) and (_held is None or path not in _held)
                # Whoever had it may have removed the file meanwhile: then this is a lock on nothing.
                current = taken and _is_at(handle, path)
            except BaseException:
                os.close(handle)
                raise
            if current:
                if _held is not None:
                    _held.add(path)
                return FileLock(path, handle)
            os.close(handle)
            if not taken:
                return None

    @staticmethod
    def wait(path: Path, longest_s: float) -> FileLock | None:
        """The lock as soon as it is free; None when somebody has it for longer than `longest_s` seconds.

        Raises:
            OSError: as for `take`.
        """
        pause = _FIRST_PAUSE_S
        end = time.monotonic() + longest_s
        while True:
            lock = FileLock.take(path)
            if lock is not None or time.monotonic() > end:
                return lock
            time.sleep(pause)
            pause = min(2 * pause, _LONGEST_PAUSE_S)

    @staticmethod
    def is_possible(folder: Path) -> bool:
        """Whether files can be locked in a folder."""
        try:
            lock = FileLock.take(folder / f".{os.urandom(4).hex()}.lock")
        except OSError:
            return False
        if lock is not None:
            lock.release()
        return True

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
        lock._forget()
        return False

    def release(self) -> None:
        """Gives it back."""
        self._forget()
        # While it is held nobody else can lock the file that is removed. Windows removes no file that is open.
        if sys.platform != "win32":
            self._remove()
        with contextlib.suppress(OSError):
            os.close(self.handle)
        if sys.platform == "win32":
            self._remove()

    def _forget(self) -> None:
        if _held is not None:
            _held.discard(self.path)

    def _remove(self) -> None:
        with contextlib.suppress(OSError):
            self.path.unlink()


def _is_at(handle: int, path: Path) -> bool:
    if sys.platform == "win32":
        return True
    try:
        there = os.stat(path)
    except FileNotFoundError:
        return False
    return os.path.samestat(os.fstat(handle), there)
