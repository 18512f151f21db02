"""Whoever fails in the example `transport-team`, all boxes arrive; with any two, they do, or the run says why not."""

from __future__ import annotations

from pathlib import Path

import pytest

import kitrobot
from kitrobot.mission.trial import FailureKind
from kitrobot.sim.sweep import Fault, Field, Task, run_task
from kitrobot.workspace.mission_run import PreparedRun, RunOptions
from kitrobot.workspace.sweep import Sweep, SweepOptions, run_sweep
from tests.effort import THOROUGH

pytestmark = pytest.mark.usefixtures("compiled_runs")

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"


def opened(example: str, seed: int) -> PreparedRun:
    return kitrobot.open(EXAMPLES / example / f"{example}.krt").prepare(RunOptions(seed, 600.0))


def swept(example: str, moments: int, pairs: bool = False, seed: int = 1) -> Sweep:
    return run_sweep(opened(example, seed), SweepOptions(moments, pairs, None if THOROUGH else 1))


@pytest.mark.parametrize("seed", [1, 2, 3, 4] if THOROUGH else [1])
def test_all_boxes_arrive_whoever_fails_whenever(seed: int) -> None:
    sweep = swept("transport-team", 100 if THOROUGH else 2, seed=seed)
    assert sweep.holds
    assert sweep.counts["done"] == sweep.total == 11 * len(sweep.moments)
    assert all("B holds all 12 boxes" in field.sentence for field in sweep.fields)


@pytest.mark.thorough("test_when_two_fail_all_boxes_arrive_or_the_team_says_who_is_missing")
def test_when_any_two_fail_all_boxes_arrive_or_the_team_says_who_is_missing() -> None:
    sweep = swept("transport-team", 20, pairs=True)
    assert sweep.holds
    assert sweep.counts["stuck"] == sweep.counts["time"] == 0
    for field in sweep.fields:
        said_or_done(field, sweep.agents)


@pytest.mark.parametrize(
    "names",
    [
        *(("loader-1", "loader-2"), ("unloader-1", "unloader-2"), ("manager-B1", "manager-B2")),
        *(("carrier-1", "carrier-2"), ("carrier-3", "loader-1"), ("unloader-2", "manager-A1")),
    ],
    ids=" ".join,
)
def test_when_two_fail_all_boxes_arrive_or_the_team_says_who_is_missing(names: tuple[str, str]) -> None:
    simulation = opened("transport-team", 1).again()
    agents = tuple(agent.name for agent in simulation.members)
    first, second = sorted(map(agents.index, names))
    (field,) = run_task(simulation, Task(Fault(first, 0), simulation.snapshot(), (second,), (0,)))
    said_or_done(field, agents)


def said_or_done(field: Field, agents: tuple[str, ...]) -> None:
    """Whether all boxes arrived, or the run says who is missing: two of one role."""
    lost = {agents[fault.agent].rstrip("12") for fault in field.faults}
    assert (field.outcome == "done") or len(lost) == 1
    assert (field.outcome == "done") or "The team cannot go on: nobody is left of " in field.sentence


@pytest.mark.parametrize("kind", [FailureKind.STALL, FailureKind.MUTE])
def test_all_boxes_arrive_whoever_stalls_or_loses_its_radio(kind: FailureKind) -> None:
    simulation = opened("transport-team", 1).again()
    first, names = simulation.snapshot(), [agent.name for agent in simulation.members]
    for number, name in enumerate(names):
        for moment in range(12) if THOROUGH else (number % 12, (number + 5) % 12):
            simulation.restore(first)
            simulation.advance(120 + 240 * moment)
            simulation.inject_fault(name, kind)
            while simulation.outcome is None:
                simulation.advance(5000)
            assert simulation.outcome == "done", (name, moment, simulation.sentence)
            assert "B holds all 12 boxes" in simulation.sentence


@pytest.mark.parametrize("away", [2.0, 3.0])
@pytest.mark.parametrize("apart", [1.5, 2.2, 4.0])
def test_all_boxes_arrive_when_each_carrier_fails_for_a_while_and_one_is_always_left(apart: float, away: float) -> None:
    simulation = opened("transport-team", 1).again()
    names = [f"carrier-{n}" for n in (1, 2, 3)]
    harms = [(2.5 + apart * n, name, FailureKind.FAIL) for n, name in enumerate(names)]
    harms += [(at + away, name, FailureKind.REVIVE) for at, name, _ in harms]
    for at, name, kind in sorted(harms):
        while simulation.seconds < at:
            simulation.step()
        simulation.inject_fault(name, kind)
    while simulation.outcome is None:
        simulation.step()
    assert simulation.outcome == "done", simulation.sentence
    assert "B holds all 12 boxes" in simulation.sentence


def test_searchers_that_are_left_search_all_rooms() -> None:
    sweep = swept("shared-search", 20 if THOROUGH else 2)
    late = [field for field in sweep.fields if field.faults[0].tick]
    assert {field.outcome for field in late} == {"done"}
