"""The compiled step of a run, made once for all workers of a run of the tests and kept in the checkout from then on.

Compiling takes a minute of processor time: one process begins with it when the tests begin, and the tests that need it
come last. Whoever needs it earlier waits for that process, or does it in its place.
"""

from __future__ import annotations

import importlib.util
import os
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

if sys.platform != "win32":
    import fcntl

CACHE = Path(__file__).resolve().parents[1] / "build" / "cache"
FIXTURES = {"with_numba", "compiled_runs"}
"""What tests ask for that are about it, and those that are quicker with it."""
COMPILE = """
from kitrobot.sim.jit.compiler import step
from tests.compiled_step import alone
with alone():
    step.is_kept() or step.wait()
"""
"""A text: what is imported here is imported by the tests of every room."""


@contextmanager
def alone() -> Iterator[None]:
    """Nobody else among the tests of this checkout compiles meanwhile."""
    CACHE.mkdir(parents=True, exist_ok=True)
    with open(CACHE / "tests.lock", "w") as lock:
        if sys.platform != "win32":
            fcntl.flock(lock, fcntl.LOCK_EX)
        yield


def begin() -> subprocess.Popen[bytes] | None:
    """The process that compiles it, or loads what is kept; None where there is nothing to compile with."""
    if importlib.util.find_spec("numba") is None:
        return None
    environment = {**os.environ, "KITROBOT_COMPILE": "", "PYTHONPATH": os.pathsep.join(filter(None, sys.path))}
    nothing = subprocess.DEVNULL
    return subprocess.Popen(
        [sys.executable, "-c", COMPILE], env=environment, stdin=nothing, stdout=nothing, stderr=nothing
    )
