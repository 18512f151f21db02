"""When a run asks for the compiled step."""

from __future__ import annotations

import pytest

from kitrobot.sim.jit import policy as jit_policy
from kitrobot.sim.jit.compiler import step
from kitrobot.sim.jit.policy import AT_ONCE, WORTH, JitPolicy, Work


def test_a_run_of_single_steps_asks_for_the_compiled_step_no_more_often(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[int] = []
    monkeypatch.setattr(jit_policy, "done", Work(WORTH))
    monkeypatch.setattr(step, "ask", lambda: asked.append(1))
    monkeypatch.setattr(step, "made", None)
    policy = JitPolicy(10)
    for _ in range(2 * AT_ONCE // 10 + 1):
        assert policy.compiled() is None
        policy.worked(1)
    assert len(asked) == 3
    made = object()
    monkeypatch.setattr(step, "made", made)
    assert policy.compiled() is made
