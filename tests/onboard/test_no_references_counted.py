"""Under Numba a tick counts no references to its arrays: that costs more than the instructions of a short tick.

Numba leaves the counting out where it can prove that nothing needs it, and the proof hangs on small things in the shape
of `tick` (see there). When this fails after an edit or with another Numba, measure with `python -m benchmarks
interpreting` before anything else.
"""

from __future__ import annotations

import re

import numpy as np
import pytest

from kitrobot_onboard.interpreter import tick

numba = pytest.importorskip("numba", reason="Numba has no wheel for this machine")


@pytest.mark.parametrize("code_type", [np.uint8, np.int32, np.int64])
def test_a_compiled_tick_counts_no_references(code_type: type[np.generic]) -> None:
    compiled = numba.njit(tick)
    numbers = numba.int32[::1]
    signature = (numba.from_dtype(np.dtype(code_type))[::1], *[numbers] * 5)
    compiled.compile(signature)
    (text,) = compiled.inspect_llvm().values()
    assert "tick" in text
    assert re.findall(r"call [^\n]*@NRT_incref", text) == []
