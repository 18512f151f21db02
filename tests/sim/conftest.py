"""The compiled step, for the tests that are about it."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from kitrobot.sim.jit import policy as jit_policy
from kitrobot.sim.jit.compiler import step
from tests import compiled_step


@pytest.fixture(scope="module")
def with_numba() -> Iterator[None]:
    """The step is compiled: once for these sources in this checkout; later it is loaded."""
    pytest.importorskip("numba")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("KITROBOT_COMPILE", "")
        with compiled_step.alone():
            assert step.wait() is not None, "Numba is here, and does not compile the step"
        # Runs are plain unless they are told to take it, however many there were before.
        patch.setattr(jit_policy, "WORTH", 10**15)
        yield
