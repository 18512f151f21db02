"""Runs one after another in a process that stays hot: compiled, put back to the beginning, measured by the stretch."""

from __future__ import annotations

import math
import random
from collections.abc import Sequence

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import kitrobot
from kitrobot.experiments.plan import Plan, StudyRequest, plan_study
from kitrobot.experiments.point_runner import Pace, PointRunner
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.step import probes
from kitrobot.sim.tables.columns import A_ROBOT, A_TAKEN, DOWN, FAILED, PROGRAM, X, Y
from kitrobot.text.json_text import from_json
from kitrobot.verifier.properties.conditions import parse_condition
from kitrobot.verifier.properties.run_conditions import declared_of, simulated_conditions, team_of
from kitrobot.workspace.mission_run import RunOptions
from tests.effort import examples
from tests.experiments.missions import short_plan

TEAM = "transport-team"
SECONDS = 6.0
CONDITIONS = {
    TEAM: (
        "any carrying (Cargo.IsPressed())",
        "all movers (Collision.IsReleased())",
        "most carrying (Sign.LessThan(6) & Run.IsTrue())",
        "any carrier-1 (Sign.GreaterThan(2)) & !(all carrying (Sign.GreaterThan(2)))",
        "any office (Run.IsFalse()) | any carrier-2 (Dock.EqualTo(3))",
    ),
    "line-follower": (
        "any robot-1 (LeftEye.IsBare())",
        "all robot-1 (RightEye.IsBare() | Captor.LessThan(90) | Fault.IsRaised())",
    ),
}


def planned(mission: str, **chosen: object) -> Plan:
    return plan_study(kitrobot.open_mission(mission), StudyRequest(**chosen))  # type: ignore[arg-type]


def error_plan() -> Plan:
    """Two points of runs, and between them one that cannot be run."""
    return short_plan("1-2", vary=[("world.width", "1000,100,900")])


@pytest.mark.parametrize(
    "plan",
    [
        pytest.param(lambda: short_plan("1-4", measures=["seconds,distance,energy,collisions"]), id="failing"),
        pytest.param(error_plan, id="refused"),
        pytest.param(
            lambda: planned(
                TEAM,
                seeds="1-3",
                seconds=9.0,
                fail_rate=0.95,
                measures=["delivered,distance,energy.carrier-1", "n=count any carrying (Cargo.IsPressed())"],
            ),
            id="team",
        ),
        pytest.param(lambda: planned("dice", seeds="1-3", seconds=9.0), id="chance"),
    ],
)
def test_a_row_made_after_others_is_byte_for_byte_the_row_that_is_made_alone(compiled_runs, plan):
    made = plan()
    order = [*range(made.rows)] * 2
    random.Random(1).shuffle(order)
    hot = PointRunner(made, pace=Pace.COMPILED)
    found: dict[int, set[bytes]] = {row: set() for row in order}
    for row in order:
        found[row].add(hot.run(row))
    for row in range(made.rows):
        assert found[row] == {PointRunner(made, pace=Pace.PLAIN).run(row)}


@pytest.mark.parametrize("mission", sorted(CONDITIONS))
@settings(max_examples=examples(2))
@given(st.integers(0, 10**6), st.sampled_from([0.0, 0.99]), st.sampled_from([500, 7]))
def test_measures_by_the_stretch_are_those_of_a_look_after_every_step(compiled_runs, mission, seed, rate, room):
    asked = [f"{kind} {text}" for text in CONDITIONS[mission] for kind in ("time", "first", "count")]
    opened = kitrobot.open_mission(mission)
    request = StudyRequest(seeds=str(seed), seconds=SECONDS, fail_rate=rate, measures=["distance", "energy", *asked])
    plan = plan_study(opened, request)
    expected = looked_at(opened.prepare(RunOptions(seed, SECONDS, rate)).simulation, CONDITIONS[mission])
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(probes, "_MOST_STEPS", room)
        for pace in (Pace.PLAIN, Pace.COMPILED):
            assert from_json(PointRunner(plan, pace=pace).run(0))["measures"] == expected


def looked_at(run: Simulation, conditions: Sequence[str]) -> dict[str, float | None]:
    """The same measures, from the tables after every step."""
    parsed = [parse_condition(text, team_of(run), declared_of(run)) for text in conditions]
    decided = simulated_conditions(parsed, run)
    distance, energy = 0.0, 0
    held: dict[str, list[bool]] = {text: [] for text in conditions}
    places = _places(run)
    while run.outcome is None:
        run.step()
        now = _places(run)
        distance += sum(math.hypot(x - was_x, y - was_y) for (x, y), (was_x, was_y) in zip(now, places, strict=True))
        places = now
        energy += _power(run)
        for one in parsed:
            held[one.text].append(decided.holds(one))
    told: dict[str, float | None] = {"distance": round(distance, 3), "energy": round(energy * run.tick_ms / 1000, 3)}
    for text, holds in held.items():
        told[f"time {text}"] = sum(holds) * run.tick_ms / 1000
        told[f"first {text}"] = (holds.index(True) + 1) * run.tick_ms / 1000 if any(holds) else None
        told[f"count {text}"] = sum(now and not before for before, now in zip([False, *holds], holds, strict=False))
    return told


def _places(run: Simulation) -> list[tuple[float, float]]:
    floats = run.state.robots.floats
    return list(zip(floats[X], floats[Y], strict=True))


def _power(run: Simulation) -> int:
    """The sizes of the numbers in all commands in force."""
    state, total = run.state, 0
    for k, robot in enumerate(state.actuators.ints[A_ROBOT]):
        taken = state.actuators.ints[A_TAKEN][k]
        if taken >= 0 and state.robots.ints[DOWN][robot] != FAILED:
            count = state.machines.commands[state.robots.ints[PROGRAM][robot]][3 * taken + 1]
            total += sum(map(abs, state.actuators.takens[k][:count]))
    return total


def test_a_run_that_is_recorded_reads_no_probes_and_a_row_after_it_is_the_same(compiled_runs, tmp_path):
    plan = short_plan("1-2")
    runner = PointRunner(plan, pace=Pace.COMPILED)
    before = [runner.run(row) for row in range(plan.rows)]
    assert runner.record(0, tmp_path / "run.krtrace") == before[0]
    assert [runner.run(row) for row in range(plan.rows)] == before
