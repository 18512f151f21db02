"""What the processes that a command or the studio begins have in common."""

from __future__ import annotations

import os
import signal
import sys
import threading
from typing import Final

MOST_JOBS: Final = 256

_possible = sys.platform != "emscripten"


def has_processes() -> bool:
    """Whether processes can be begun: not in a page, where all is done in the one that there is."""
    return _possible


def do_without_processes() -> None:
    """From now on none are begun here."""
    global _possible
    _possible = False


def cores() -> int:
    """The cores that this process may use, at most `MOST_JOBS`."""
    if not _possible:
        return 1
    usable = getattr(os, "sched_getaffinity", None)
    return max(1, min(MOST_JOBS, len(usable(0)) if usable is not None else os.cpu_count() or 1))


def end_with_parent() -> None:
    """In a process of ours, once: Ctrl-C is the parent's, which says so to all; it ends when the parent is gone."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=_end, daemon=True).start()


def _end() -> None:
    import multiprocessing

    parent = multiprocessing.parent_process()
    if parent is not None:
        parent.join()
        os._exit(1)
