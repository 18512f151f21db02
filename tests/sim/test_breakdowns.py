"""What becomes of robots that fail on a road: they stay, are towed with their box, or are driven round."""

from __future__ import annotations

from dataclasses import replace

import pytest

from kitrobot.mission.breakdown import Breakdown, BreakdownRule
from kitrobot.mission.trial import Failure, FailureKind
from kitrobot.sim.host_step import begin_hosted_step, finish_hosted_step
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.sweep import Fault, Task, run_task, snapshots_at
from tests.effort import cases
from tests.sim.building import catalogue, example_images, transport

TOW, PASS = BreakdownRule.TOW, BreakdownRule.PASS


def ring(
    rule: BreakdownRule,
    *failures: Failure,
    after_s: float = 5.0,
    seed: int = 1,
    capacity: int = 12,
    stock: int = 12,
) -> Simulation:
    """The transport mission with this rule and these failures; A has so much room."""
    made = transport(seed, stock, failures=failures)
    mission = replace(made.mission, breakdown=Breakdown(rule, after_s if rule is TOW else 0.0))
    houses = tuple(replace(one, capacity=capacity) if one.name == "A" else one for one in made.world.storehouses)
    return Simulation(mission, replace(made.world, storehouses=houses), example_images(), catalogue(), seed, 600)


def told(run: Simulation, word: str) -> list[tuple[float, str, str]]:
    """Runs to the end; what was said with that word: when, by whom, what."""
    found = []
    while run.outcome is None:
        run.step()
        load = sum(run.stage.bodies.load)
        lost = sum(agent.lost_its_box for agent in run.members)
        assert run.total == sum(run.stock.values()) + load + lost
        found += [(event.tick * 0.02, event.agent, event.text) for event in run.events if word in event.text]
    return found


def test_without_a_rule_a_failed_robot_stays_in_the_way() -> None:
    run = ring(BreakdownRule.STAY, Failure("carrier-2", 10))
    assert told(run, "towed") == []
    assert run.outcome == "stuck"


@pytest.mark.parametrize("moment", cases([0.0, 7.4, 31.3], [5.0, 10.0, 13.7, 20.0, 50.0]))
def test_a_towed_robot_frees_the_road_and_its_box_goes_back(moment: float) -> None:
    run = ring(TOW, Failure("carrier-2", moment))
    words = told(run, "towed")
    assert [who for _, who, _ in words] == ["carrier-2"]
    assert moment + 5 <= words[0][0] < moment + 6
    assert (run.outcome, run.stock, run.collisions) == ("done", {"A": 0, "B": 12}, 0), run.sentence
    assert run.view(1).load == 0
    assert run.view(1).y_mm < 0


def test_a_body_whose_program_runs_elsewhere_is_towed_too() -> None:
    run = ring(TOW, Failure("carrier-2", 1.0))
    while run.tick < 400:
        begin_hosted_step(run)
        finish_hosted_step(run, {})
    assert [event.agent for event in run.happened() if "is towed" in event.text] == ["carrier-2"]
    assert run.view(1).y_mm < 0


def test_a_box_comes_back_to_where_it_came_from_and_is_brought_by_another() -> None:
    run = ring(TOW, Failure("carrier-1", 6.0))
    assert told(run, "its box") == [(11.0, "carrier-1", "is towed away; its box is back in A")]
    assert run.delivered["carrier-1"] == 0
    assert sum(run.delivered.values()) == 12


def test_a_load_that_misses_a_carrier_which_is_towed_meanwhile_is_made_again() -> None:
    run = ring(TOW, Failure("carrier-1", 2.0), after_s=1.0)
    assert len(told(run, "no empty carrier")) == 1
    assert (run.outcome, run.stock) == ("done", {"A": 0, "B": 12}), run.sentence


def test_a_box_that_comes_back_while_the_manager_of_a_is_stalled_is_loaded_when_that_goes_on() -> None:
    stalled = [Failure("store-manager-A", 5.0, FailureKind.STALL), Failure("store-manager-A", 90.0, FailureKind.REVIVE)]
    run = ring(TOW, Failure("carrier-1", 6.0), *stalled)
    told(run, "")
    assert (run.outcome, run.stock) == ("done", {"A": 0, "B": 12}), run.sentence


def test_a_box_for_which_there_is_no_room_is_lost_by_name() -> None:
    run = ring(TOW, Failure("carrier-1", 6.0))
    run.advance(round(10.9 / 0.02))
    run.state.docks.capacity[0] = run.stock["A"]
    assert told(run, "its box") == [(11.0, "carrier-1", "is towed away; its box is lost: A is full")]
    assert run.outcome != "done"
    assert "the box of carrier-1 is lost" in run.sentence


def test_others_drive_round_a_robot_whose_box_stays_on_it() -> None:
    run = ring(PASS, Failure("carrier-1", 6.0))
    assert [who for _, who, _ in told(run, "drive round")] == ["carrier-1"]
    assert (run.stock["B"], run.view(0).load, run.collisions) == (11, 1, 0)
    assert run.outcome == "stuck"


def test_who_was_driven_round_is_on_its_road_again_when_it_is_revived() -> None:
    run = ring(PASS, Failure("carrier-1", 6.0), Failure("carrier-1", 40.0, FailureKind.REVIVE))
    told(run, "drive round")
    assert (run.outcome, run.stock["B"]) == ("done", 12), run.sentence


def test_who_was_towed_is_not_revived_and_who_is_revived_in_time_is_not_towed() -> None:
    late = ring(TOW, Failure("carrier-1", 3.0), Failure("carrier-1", 20.0, FailureKind.REVIVE))
    assert len(told(late, "towed")) == 1
    assert (late.outcome, late.delivered["carrier-1"], late.view(0).state) == ("done", 0, "failed")
    in_time = ring(TOW, Failure("carrier-1", 3.0), Failure("carrier-1", 6.0, FailureKind.REVIVE))
    assert told(in_time, "towed") == []
    assert (in_time.outcome, in_time.stock["B"]) == ("done", 12)


def test_when_all_have_failed_the_last_one_is_still_towed() -> None:
    run = ring(TOW, *(Failure(f"carrier-{n}", 8.0) for n in (1, 2, 3)))
    assert len(told(run, "towed")) == 3
    assert run.outcome == "stuck"
    assert sum(run.stock.values()) == 12


def test_fields_of_a_sweep_with_towing_are_runs_from_the_start() -> None:
    moment = 333
    [field] = run_task(ring(TOW), Task(Fault(1, moment), snapshots_at(ring(TOW), [moment])[moment]))
    run = ring(TOW, Failure("carrier-2", moment * 0.02))
    told(run, "")
    assert (field.outcome, field.sentence, field.ticks) == (run.outcome, run.sentence, run.tick)


@pytest.mark.usefixtures("with_numba")
@pytest.mark.parametrize("rule", [TOW, PASS])
def test_plain_and_compiled_steps_give_the_same(rule: BreakdownRule) -> None:
    failures = (
        Failure("carrier-1", 6.0),
        Failure("carrier-2", 7.0),
        Failure("carrier-1", 15.0, FailureKind.REVIVE),
        Failure("carrier-3", 20.0, FailureKind.STALL),
    )
    runs = [ring(rule, *failures) for _ in range(2)]
    runs[0].stays_plain = True
    assert runs[1].compile_step()
    for steps in (290, 20, 200, 300, 1, 2000):
        for run in runs:
            run.advance(steps)
        assert runs[0].snapshot() == runs[1].snapshot()
    assert runs[0].sentence == runs[1].sentence
