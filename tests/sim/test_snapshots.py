"""Snapshots: the whole state as bytes, from which any process goes on alike, and which only its own run takes."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kitrobot.sim.recorder import Recorder
from kitrobot.sim.setup.limits import SimulationError
from tests.effort import cases, examples
from tests.patience import PATIENCE_S
from tests.sim.building import catalogue, empty_world, run_of, transport
from tests.sim.teams import random_team

ROOT = Path(__file__).parents[2]
CHILD = """
import sys
from tests.sim.teams import random_team
run = random_team(int(sys.argv[1]), 9)
run.restore(sys.stdin.buffer.read())
for _ in range(120):
    run.step()
sys.stdout.buffer.write(run.snapshot())
"""


@settings(max_examples=examples(10))
@given(st.integers(0, 10**9), st.integers(1, 12), st.integers(0, 120), st.integers(1, 60))
def test_going_back_and_on_again_is_the_same_run(seed: int, robots: int, before: int, after: int) -> None:
    run = random_team(seed, robots)
    run.advance(before)
    kept = run.snapshot()
    recorder = Recorder(run)

    def deliver_answer() -> list[object]:
        told: list[object] = []
        for _ in range(after):
            run.step()
            told.append((recorder.record(), list(run.events), run.poses()))
        return [told, run.agents, run.snapshot(), run.outcome, run.sentence]

    first = deliver_answer()
    run.restore(kept)
    assert run.tick == before
    assert run.snapshot() == kept
    assert deliver_answer() == first


@pytest.mark.parametrize("seed", cases([1], [2, 3]))
def test_another_process_goes_on_identically(seed: int) -> None:
    run = random_team(seed, 9)
    run.advance(77)
    kept = run.snapshot()
    environment = {**os.environ, "PYTHONPATH": f"{ROOT}:{ROOT / 'src'}", "PYTHONHASHSEED": str(seed)}
    child = subprocess.run(
        [sys.executable, "-c", CHILD, str(seed)], input=kept, env=environment, capture_output=True, timeout=PATIENCE_S
    )
    assert child.returncode == 0, child.stderr.decode()
    for _ in range(120):
        run.step()
    assert child.stdout == run.snapshot()


def test_a_run_that_has_ended_goes_back_to_before_its_end_and_forward_to_it() -> None:
    run = transport(1, 1, 1)
    run.advance(200)
    kept = run.snapshot()
    while run.outcome is None:
        run.step()
    last, end = run.snapshot(), (run.outcome, run.sentence, run.events)
    run.restore(kept)
    assert (str(run.outcome), run.sentence, run.tick) == ("None", "", 200)
    run.restore(last)
    assert (run.outcome, run.sentence, run.events) == end


def test_what_is_forced_is_part_of_the_state() -> None:
    mini = catalogue().robots["mini-robot"]
    run = run_of({"a": (mini, "WAIT(600);")}, empty_world(a=(1000, 1000, 0)))
    free = run.snapshot()
    run.force("a", "Button", 1)
    forced = run.snapshot()
    run.restore(free)
    run.step()
    assert run.agents[0].inputs["Button"] == 0
    run.restore(forced)
    run.step()
    assert run.agents[0].inputs["Button"] == 1


def test_a_run_does_not_take_the_state_of_another() -> None:
    one, other = transport(1), transport(2)
    kept = other.snapshot()
    before = one.snapshot()
    with pytest.raises(SimulationError, match="of another run"):
        one.restore(kept)
    assert one.snapshot() == before


@pytest.mark.parametrize("damage", ["cut", "empty", "changed", "longer"])
def test_damaged_bytes_are_refused_and_nothing_changes(damage: str) -> None:
    run = transport(1)
    run.advance(100)
    kept = run.snapshot()
    run.advance(100)
    now = run.snapshot()
    bad = {"cut": kept[:-8], "empty": b"", "changed": kept[:-1] + b"\x7f", "longer": kept + b"\0"}[damage]
    with pytest.raises(SimulationError, match="not a whole snapshot"):
        run.restore(bad)
    assert run.snapshot() == now
