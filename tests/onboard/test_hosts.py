"""The one `tick` gives the same arrays on plain CPython and compiled by Numba, after every tick."""

from __future__ import annotations

import os
import random
import re
from collections.abc import Callable
from typing import Any

import pytest

from kitrobot.image.machine import Machine
from kitrobot_onboard.interpreter import tick
from tests.effort import cases
from tests.oracle.agreement import machine_for, random_case
from tests.strategies import TickInputs

BUDGET = int(os.environ.get("KITROBOT_BUDGET", "60"))


@pytest.fixture(scope="module")
def numba() -> Any:
    """Numba, which takes half a second to import: not where no test needs it."""
    return pytest.importorskip("numba", reason="Numba has no wheel for this machine")


@pytest.fixture(scope="module")
def compiled_tick(numba: Any) -> Callable[..., None]:
    return numba.njit(tick)  # type: ignore[no-any-return]


def as_arrays(machine: Machine) -> dict[str, Any]:
    """The machine's state in the words that a fleet uses: 32 bits a number, bytes for code."""
    import numpy as np

    numbers = {name: np.array(getattr(machine, name), np.int32) for name in ("cells", "threads", "pars", "out", "seen")}
    return {"code": np.array(machine.code, np.uint8), **numbers}


def test_plain_and_numba_give_equal_arrays_after_every_tick(compiled_tick: Callable[..., None]) -> None:
    compared = 0
    for seed in range(BUDGET):
        case = random_case(random.Random(f"hosts/{seed}"))
        machine = machine_for(case)
        if machine is None:
            continue
        machine.seen = [0] * machine.image.instructions if seed % 2 else []
        arrays = as_arrays(machine)
        for number, (inputs, done) in enumerate(case.script):
            for sensor, value in inputs.items():
                machine.set_input(sensor, value)
            for actuator, is_done in done.items():
                machine.set_done(actuator, is_done)
            last_input = machine.layout.inputs + 1
            arrays["cells"][1:last_input] = machine.cells[1:last_input]
            arrays["seen"][:] = 0
            machine.tick()
            compiled_tick(*(arrays[name] for name in ("code", "cells", "threads", "pars", "out", "seen")))
            for name, array in arrays.items():
                assert array.tolist() == list(getattr(machine, name)), (seed, number, name)
        compared += 1
    assert compared > 0.8 * BUDGET


@pytest.mark.parametrize("code_type", cases(["uint8"], ["int32", "int64"]))
def test_a_compiled_tick_counts_no_references(numba: Any, compiled_tick: Any, code_type: str) -> None:
    """Counting references to its arrays costs more than the instructions of a short tick.

    Numba leaves it out where it can prove that nothing needs it, and the proof hangs on small things in the shape of
    `tick` (see there). When this fails after an edit or with another Numba, measure with `python -m benchmarks
    interpreting` before anything else.
    """
    signature = (getattr(numba, code_type)[::1], *[numba.int32[::1]] * 5)
    compiled_tick.compile(signature)
    text = compiled_tick.inspect_llvm(signature)
    assert "tick" in text
    assert re.findall(r"call [^\n]*@NRT_incref", text) == []


def test_a_snapshot_brings_back_the_same_future() -> None:
    for seed in range(BUDGET // 4):
        case = random_case(random.Random(f"snapshot/{seed}"))
        machine = machine_for(case)
        if machine is None:
            continue
        middle = len(case.script) // 2
        run(machine, case.script[:middle])
        snapshot = machine.snapshot()
        future = run(machine, case.script[middle:])
        machine.restore(snapshot)
        assert run(machine, case.script[middle:]) == future, seed


def run(machine: Machine, script: list[TickInputs]) -> list[object]:
    """All that can be seen of a machine, tick by tick."""
    future: list[object] = []
    for inputs, done in script:
        for sensor, value in inputs.items():
            machine.set_input(sensor, value)
        for actuator, is_done in done.items():
            machine.set_done(actuator, is_done)
        future.append((machine.tick(), machine.variables(), machine.fault, machine.ended, machine.active()))
    return future
