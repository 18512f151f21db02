"""Compiler plus onboard interpreter do what the oracle says, on random programs and inputs, in every tick.

`KITROBOT_BUDGET=20000 pytest tests/oracle` compares that many seeded programs; `HYPOTHESIS_PROFILE=thorough` gives
Hypothesis more as well.
"""

from __future__ import annotations

import os
import random

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.effort import examples
from tests.oracle.agreement import disagreement, first_difference, machine_for, random_case, report, small_case
from tests.patience import PATIENCE_S

BUDGET = int(os.environ.get("KITROBOT_BUDGET", "600"))
STREAMS = 4


@pytest.mark.timeout(0 if BUDGET > 1000 else PATIENCE_S)
@pytest.mark.parametrize("stream", range(STREAMS))
def test_the_machine_does_what_the_oracle_says(stream: int) -> None:
    compared = 0
    for number in range(BUDGET // STREAMS):
        seed = f"{stream}/{number}"
        case = random_case(random.Random(seed))
        machine = machine_for(case)
        if machine is None:
            continue
        compared += 1
        if first_difference(machine, case) is not None:
            pytest.fail(f"seed {seed}:\n{report(case)}")
    assert compared > 0.8 * (BUDGET // STREAMS), "too many programs were refused for their size"


@settings(max_examples=examples(15))
@given(st.randoms(note_method_calls=False))
def test_the_machine_does_what_the_oracle_says_on_small_programs(rng: random.Random) -> None:
    case = small_case(rng)
    assert disagreement(case) is None
