"""`log.txt` of a class: who joined, what was handed in and out, who was refused; one line each, in English.

It is appended to and never read; if it cannot be written, the class goes on without it.
"""

from __future__ import annotations

import contextlib
import threading
from collections import deque
from datetime import datetime
from pathlib import Path
from typing import Final

NAME: Final = "log.txt"
MOST_SHOWN: Final = 500
LARGEST_BYTES: Final = 4 * 1024 * 1024
"""A longer one is put aside as `log.txt~` first."""


class Log:
    """The log of a folder. Safe to use from many threads."""

    def __init__(self, folder: Path) -> None:
        self._path = folder / NAME
        self._lock = threading.Lock()
        self._last: deque[str] = deque(maxlen=MOST_SHOWN)

    def write(self, text: str) -> None:
        """Adds a line."""
        line = f"{datetime.now():%Y-%m-%d %H:%M:%S}  {' '.join(text.split())}"
        with self._lock:
            self._last.append(line)
            with contextlib.suppress(OSError, ValueError):
                if self._path.exists() and self._path.stat().st_size > LARGEST_BYTES:
                    self._path.replace(self._path.with_name(f"{NAME}~"))
                with self._path.open("a", encoding="utf-8", errors="replace") as stream:
                    stream.write(line + "\n")

    def last(self) -> list[str]:
        """The last lines of this process, the newest first."""
        with self._lock:
            return list(reversed(self._last))
