"""Long work without Numba says once, in one sentence, what would make it faster."""

from __future__ import annotations

import platform

import pytest

from kitrobot.files.examples import examples_folder
from kitrobot.sim.jit import cache as jit_cache
from kitrobot.sim.jit import policy as jit_policy
from kitrobot.verifier.exploration import engine_policy
from tests.cli.conftest import EXAMPLE

SAYS = 'Numba makes this many times as fast: `pip install "kitrobot[fast]"`'
EXAMPLES = examples_folder()
assert EXAMPLES is not None
RING = EXAMPLES / "passing-loop" / "passing-loop.krt"


@pytest.fixture
def without_numba(monkeypatch):
    monkeypatch.setenv("KITROBOT_COMPILE", "")
    monkeypatch.setattr(jit_cache, "available", lambda: False)
    monkeypatch.setattr(platform, "machine", lambda: "x86_64")
    monkeypatch.setattr("sys.platform", "linux")
    # All of these are long.
    monkeypatch.setattr(jit_policy, "GAIN", 10)
    monkeypatch.setattr(engine_policy, "WORTH_STATES", 10)
    return monkeypatch


RUN = ("run", EXAMPLE, "--seconds", "2")
SWEEP = (*RUN, "--fail-sweep", "1", "--jobs", "1")
VERIFY = ("verify", RING, "--timing", "lockstep", "--max-states", "100")


@pytest.mark.parametrize("command", [RUN, SWEEP, VERIFY], ids=["run", "sweep", "verify"])
def test_long_work_says_once_what_would_make_it_faster_and_json_stays_data(kitrobot, without_numba, command):
    said = kitrobot(*command)
    assert (said.out + said.err).count(SAYS) == 1
    said = kitrobot(*command, "--json")
    assert SAYS not in said.out + said.err
    assert said.json


def test_nothing_is_said_where_it_could_not_be_had_or_nobody_wants_it(kitrobot, without_numba):
    without_numba.setenv("KITROBOT_COMPILE", "no")
    assert SAYS not in kitrobot(*RUN).out
    without_numba.setenv("KITROBOT_COMPILE", "")
    without_numba.setattr(platform, "machine", lambda: "riscv64")
    assert SAYS not in kitrobot(*RUN).out


def test_one_step_fewer_is_not_long(without_numba):
    assert jit_policy.would_gain(10)
    assert not jit_policy.would_gain(9)
