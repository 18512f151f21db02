"""The memory that the process of a check takes.

A memory limit is for the whole process: what it took before, states, steps and tables, the copies that are made while
they grow, and what the later search takes. On Linux the system reports what the process takes now; elsewhere it is
estimated from the sizes of what was explored.
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
