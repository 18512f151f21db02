"""What the processes that a command or the studio begins have in common."""

from __future__ import annotations

import os
import signal
import sys
import threading
from typing import Final

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.text.sentences import Sentence

MOST_JOBS: Final = 256

_possible = sys.platform != "emscripten"


class JobsError(KitRobotError):
    """Work cannot be shared out over so many processes."""


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


def check_jobs(jobs: int | None) -> None:
    """Refuses a number of processes that work cannot be shared out over; None is one for each core.

    Raises:
        JobsError: it is not 1 to `MOST_JOBS`.
    """
    if jobs is not None and not 1 <= jobs <= MOST_JOBS:
        raise JobsError(Sentence("work is shared out over 1 to {most} processes", MOST_JOBS))


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
