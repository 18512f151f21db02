"""How much memory the process of a check takes, and whether there is room for more.

A limit is the process's: what it took before, states, steps and tables, the copies that are made while they grow, and
what judging will take. Where the system tells what the process takes now (Linux), that is asked; elsewhere it is put
together from the sizes of what was explored.
"""

from __future__ import annotations

import os
from pathlib import Path

USUAL = 150_000_000
"""Bytes that a process with Python, our modules, NumPy and Numba takes, where the system does not tell."""
_STATM = Path("/proc/self/statm")


def resident() -> int:
    """Bytes of memory that this process takes now; 0 where the system does not tell."""
    try:
        pages = int(_STATM.read_text(encoding="ascii").split()[1])
        return pages * os.sysconf("SC_PAGE_SIZE")
    except (OSError, ValueError, IndexError, AttributeError):
        return 0
