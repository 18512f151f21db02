"""Keys of a terminal as they are pressed, without waiting for Enter; the terminal is as it was afterwards."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager

ESCAPE = "\x1b"
_MOST = 32


@contextmanager
def read_keys() -> Iterator[Callable[[], str]]:
    """Yields a function that returns the pressed key as its character, or "" for none. Ctrl+C works as usual."""
    if sys.platform == "win32":
        yield _windows_key
        return
    import select
    import termios
    import tty

    terminal = sys.stdin.fileno()
    before = termios.tcgetattr(terminal)

    waiting: list[str] = []

    def key() -> str:
        if not waiting and select.select([terminal], [], [], 0)[0]:
            data = os.read(terminal, _MOST).decode(errors="replace")
            if not data:
                return ESCAPE  # the terminal is gone
            if not (data.startswith(ESCAPE) and len(data) > 1):  # an arrow and the like, which nobody knows here
                waiting.extend(data)
        return waiting.pop(0) if waiting else ""

    try:
        tty.setcbreak(terminal)
        yield key
    finally:
        termios.tcsetattr(terminal, termios.TCSADRAIN, before)


def _windows_key() -> str:
    import msvcrt

    return msvcrt.getwch() if msvcrt.kbhit() else ""  # type: ignore[attr-defined, unused-ignore]
