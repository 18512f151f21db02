"""What the processes that a command or the studio begins have in common."""

from __future__ import annotations

import multiprocessing
import os
import signal
import threading
from typing import Final

MOST_JOBS: Final = 256


def cores() -> int:
    """The cores that this process may use, at most `MOST_JOBS`."""
    usable = getattr(os, "sched_getaffinity", None)
    return max(1, min(MOST_JOBS, len(usable(0)) if usable is not None else os.cpu_count() or 1))


def end_with_parent() -> None:
    """In a process of ours, once: Ctrl-C is the parent's, which says so to all; it ends when the parent is gone."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=_end, daemon=True).start()


def _end() -> None:
    parent = multiprocessing.parent_process()
    if parent is not None:
        parent.join()
        os._exit(1)
