"""Many runs of the examples."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from kitrobot.sim.jit import policy
from kitrobot.sim.jit.compiler import step
from tests import compiled_step


@pytest.fixture(scope="module")
def compiled_runs() -> Iterator[None]:
    """Runs take the compiled step, where there is Numba: many of them take a tenth of the time."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("KITROBOT_COMPILE", "")
        with compiled_step.alone():
            step.wait()
        patch.setattr(policy, "WORTH", 0)
        yield
