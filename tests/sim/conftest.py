"""The compiled step, for the tests that are about it."""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

import pytest

from kitrobot.sim.jit import policy as jit_policy
from kitrobot.sim.jit.compiler import step

if sys.platform != "win32":
    import fcntl


@pytest.fixture(scope="module")
def with_numba() -> Iterator[None]:
    """The step is compiled: once for these sources on a machine, by one of pytest's workers; later it is loaded."""
    pytest.importorskip("numba")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("KITROBOT_COMPILE", "")
        with open(Path(tempfile.gettempdir(), "kitrobot-tests-compile.lock"), "w") as lock:
            if sys.platform != "win32":
                fcntl.flock(lock, fcntl.LOCK_EX)
            assert step.wait() is not None, "Numba is here, and does not compile the step"
        # Runs are plain unless they are told to take it, however many there were before.
        patch.setattr(jit_policy, "WORTH", 10**15)
        yield
