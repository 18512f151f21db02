"""Ready properties of stock, meetings and marked actions, and of carriers that are served: what holds, and what breaks
them, with a run of the simulator that shows it.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from kitrobot.checking.verification import VerificationOptions, verify_runs
from kitrobot.lll.parse_results import parse_team
from kitrobot.mission.breakdown import BreakdownRule
from kitrobot.mission.trial import FailureKind
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.tables import columns as c
from kitrobot.verifier.exploration.budget import Budget
from kitrobot.verifier.exploration.exploration import explore
from kitrobot.verifier.model.abstraction import abstract_run
from kitrobot.verifier.model.model import Model
from kitrobot.verifier.model.timing import Timing
from kitrobot.verifier.properties.properties import ready_properties
from kitrobot.verifier.properties.verdicts import Verdict, check_properties
from kitrobot.verifier.report.replay import ConfirmedRun, confirm, judge_run
from tests.sim.building import WHEEL, avatar, empty_world, run_of, transport
from tests.sim.team_building import RunningTeam
from tests.verifier.check_fixtures import mutant

KEY = '<sensor name="Key" device="button" type="boolean"><operation name="IsPressed" test="equal" to="1"/></sensor>'


def checked(fresh: Callable[[int], Simulation], name: str, failures: int = 0) -> tuple[Verdict, ConfirmedRun | None]:
    """The verdict on one property in lockstep, and the run of the simulator that confirms it where it is broken."""
    run = fresh(1)
    model = Model(run, abstract_run(run), failures, Timing.LOCKSTEP, (FailureKind.FAIL,))
    [one] = [one for one in ready_properties(model) if one.name == name]
    made = check_properties(model, [one], Budget(50_000))
    [verdict] = made.verdicts
    assert made.complete
    return verdict, None if verdict.counterexample is None else confirm(
        one, verdict.counterexample, model, fresh, lambda: False
    )


def team(body: str) -> Callable[[int], Simulation]:
    """Runs of two robots, a scout and a helper."""
    declared = "role scout: ant; role helper: ant; group both = {scout, helper}; work Boxes = 1;"
    parsed = parse_team(f"{declared} {body}")
    assert parsed.diagnostics == []
    maker: Any = SimpleNamespace(agents={"scout-0": ("ant", "scout"), "helper-0": ("ant", "helper")}, programs={})
    running = RunningTeam(maker, parsed.program, 1)
    return lambda seed: running.anew()


def test_no_box_is_lost_as_long_as_nobody_fails_and_their_number_is_the_same_in_every_state() -> None:
    def fresh(seed: int) -> Simulation:
        return transport(seed, stock=2, carriers=1)

    verdict, _ = checked(fresh, "stock")
    assert verdict.answer.value == "holds"
    run = fresh(1)
    made = explore(Model(run, abstract_run(run)), Budget(), False)
    model = made.model
    states = [made.state(number) for number in range(len(made))]
    boxes = {
        sum(model.shareds()[state[0]][1 : 1 + model.houses])
        + sum(model.inside(i, state[1 + i]).load for i in range(model.count))
        for state in states
    }
    assert boxes == {2}


def test_a_box_on_a_robot_that_fails_is_held_by_it_and_not_delivered() -> None:
    def fresh(seed: int) -> Simulation:
        return transport(seed, stock=1, carriers=1)

    verdict, _ = checked(fresh, "stock", failures=1)
    assert verdict.answer.value == "holds"
    missed, shown = checked(fresh, "delivered", failures=1)
    assert missed.answer.value == "broken"
    assert shown is not None
    run, start_monitor = fresh(1), verdict.property.monitor
    assert start_monitor is not None
    monitor = start_monitor(run)
    while not run.state.robots.ints[c.LOAD][0]:
        run.advance(1)
    run.inject_fault("carrier-1", "fail")
    for _ in range(100):
        run.advance(1)
        assert not monitor.after_step()
    towed = fresh(1)
    towed.mission.breakdown = type(towed.mission.breakdown)(BreakdownRule.TOW)
    model = Model(towed, abstract_run(towed), 1)
    assert "stock" not in [one.name for one in ready_properties(model)]
    assert "stock" in [one.name for one in ready_properties(Model(towed, abstract_run(towed)))]


@pytest.mark.parametrize(("failures", "holder"), [(0, ""), (1, "a box or a unit of work that a robot holds")])
def test_with_failures_it_is_said_that_who_fails_holds_what_it_held(failures: int, holder: str) -> None:
    options = VerificationOptions(("stock",), (Timing.LOCKSTEP,), failures, (FailureKind.FAIL,), 200, None)
    made = verify_runs(lambda seed: transport(seed, stock=1, carriers=1), 1, options)
    assert [str(limit)[: len(holder)] for limit in made.limits] == ([holder] if holder else [])


@pytest.mark.parametrize(("done", "answer"), [("Boxes.Done();", "holds"), ("", "broken")])
def test_a_unit_of_work_that_is_taken_and_never_done_is_lost(done: str, answer: str) -> None:
    verdict, shown = checked(team(f"ParOfSeq both ( Boxes.Take(); Arm.Do(1); {done} );"), "stock")
    assert verdict.answer.value == answer
    assert (shown is not None) == (answer == "broken")


@pytest.mark.parametrize(("done", "answer"), [("Boxes.Done();", "holds"), ("", "broken")])
def test_a_unit_on_a_robot_that_fails_is_not_lost_and_what_its_program_loses_is(done: str, answer: str) -> None:
    verdict, _ = checked(team(f"ParOfSeq both ( Boxes.Take(); Arm.Do(1); {done} );"), "stock", failures=1)
    assert verdict.answer.value == answer


WAITS = """Where {scout} [Count.LessThan(1)]( Arm.Do(1); %s ) ! ( );
SeqOfPar both ( Arm.Do(2); );"""


@pytest.mark.parametrize(("body", "answer"), [("", "holds"), ("<Boxes.IsEmpty()>( Arm.Do(3); );", "broken")])
def test_who_waits_for_a_member_that_never_comes_waits_for_ever(body: str, answer: str) -> None:
    fresh = team(WAITS % body)
    verdict, shown = checked(fresh, "meets-helper-0")
    assert verdict.answer.value == answer
    assert (shown is not None) == (answer == "broken")
    other, _ = checked(fresh, "meets-scout-0")
    assert other.answer.value in ("holds", "vacuous")


STOPS = "//( WAIT(2); <Key.IsPressed()>(%s);, °Wheel.Advance(50)°; );%s"


@pytest.mark.parametrize(
    ("body", "after", "answer"),
    [
        ("", "", "holds"),
        ("Wheel.Reverse(20);", "", "broken"),
        ("Wheel.Reverse(20);", " WAIT(5); Wheel.Stop();", "holds"),
        ("Wheel.Reverse(20); WAIT(5);", "", "holds"),
        ("Wheel.Stop();", "", "holds"),
    ],
)
def test_what_a_marked_action_started_and_another_branch_took_over_is_to_stand_in_the_end(
    body: str, after: str, answer: str
) -> None:
    robot = avatar(KEY, WHEEL.format(settings=""))

    def fresh(seed: int) -> Simulation:
        run = run_of({"a": (robot, STOPS % (body, after))}, empty_world(a=(400.0, 400.0, 0.0)), seed=seed)
        run.force("a", "Key", 1)
        return run

    verdict, shown = checked(fresh, "stopped")
    assert verdict.answer.value == answer
    assert (shown is not None) == (answer == "broken")


@pytest.mark.parametrize("first", ["", "WAIT(3); "])
def test_what_a_marked_action_of_one_tick_started_and_another_branch_took_over_is_confirmed(first: str) -> None:
    robot = avatar(KEY, WHEEL.format(settings=""))

    def fresh(seed: int) -> Simulation:
        text = first + "//( °Wheel.Advance(50)°;, Wheel.Reverse(20); );"
        return run_of({"a": (robot, text)}, empty_world(a=(400.0, 400.0, 0.0)), seed=seed)

    verdict, shown = checked(fresh, "stopped")
    assert verdict.answer.value == "broken"
    assert shown is not None


def test_a_program_without_an_end_or_without_marked_actions_is_not_asked_whether_they_stop() -> None:
    robot = avatar(KEY, WHEEL.format(settings=""))
    world = empty_world(a=(400.0, 400.0, 0.0))
    for text in (
        "*( //( <Key.IsPressed()>();, °Wheel.Advance(50)°; ); );",
        "Wheel.Advance(50); WAIT(5); Wheel.Stop();",
    ):
        run = run_of({"a": (robot, text)}, world)
        assert "stopped" not in [one.name for one in ready_properties(Model(run, abstract_run(run)))]


def test_a_carrier_that_nobody_serves_waits_in_its_dock_for_ever(tmp_path: Path) -> None:
    """The loader loads only until B has counted, which it has before the carrier comes."""
    old = '<vertex id="v7" element="Counted.IsTrue"/>'
    prepared = mutant(tmp_path, (old, old.replace("IsTrue", "IsFalse")), carriers=1, stock=1)
    verdict, shown = checked(lambda seed: prepared.again(), "served-carrier-1")
    assert verdict.answer.value == "broken"
    assert verdict.counterexample is not None
    assert verdict.counterexample.repeats_from >= 0
    assert shown is not None


def test_a_run_that_is_stuck_breaks_only_what_is_said_of_the_carrier_that_stands_in_a_dock(tmp_path: Path) -> None:
    """The same: the first carrier stands in the dock, the second one behind it on the road."""
    old = '<vertex id="v7" element="Counted.IsTrue"/>'
    prepared = mutant(tmp_path, (old, old.replace("IsTrue", "IsFalse")), carriers=2, stock=1)
    run = prepared.again()
    found = {one.name: one for one in ready_properties(Model(run, abstract_run(run)))}
    broken = [
        name
        for name in ("deadlock", "served-carrier-1", "served-carrier-2")
        if judge_run(found[name], prepared.again(), (), lambda: False).is_broken
    ]
    assert broken == ["deadlock", "served-carrier-1"]
