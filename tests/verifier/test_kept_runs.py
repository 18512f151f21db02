"""Runs of the simulator that keep what another one breaks: the same up to a moment, and where there is none."""

from __future__ import annotations

from dataclasses import replace

import pytest

from kitrobot.checking.verification import VerificationOptions, verify, verify_runs
from kitrobot.checking.verification_result import Finding
from kitrobot.mission.property_forms import AskedProperty, Form
from kitrobot.mission.trial import Failure, FailureKind
from kitrobot.verifier.model.timing import Timing
from kitrobot.verifier.report.kept_run import KeptRun, find_kept_run
from kitrobot.verifier.report.replay import judge_run
from kitrobot.workspace.mission_run import PreparedRun, RunOptions
from kitrobot.workspace.previews import Preview, record_stretch
from tests.verifier.check_fixtures import mutant
from tests.verifier.test_explanations import robots
from tests.verifier.test_known_answers import UNCOUNTED


@pytest.fixture(scope="module")
def uncounted(tmp_path_factory: pytest.TempPathFactory) -> tuple[PreparedRun, Finding]:
    """A mission whose loader reaches for a box that is not there, and what a check says of it."""
    prepared = mutant(tmp_path_factory.mktemp("uncounted"), UNCOUNTED, stock=1)
    options = VerificationOptions(("empty-storehouse",), (Timing.LOCKSTEP,), seconds=None, explains=True)
    return prepared, verify(prepared, options).columns[0].findings[0]


def kept_of(finding: Finding) -> KeptRun:
    assert finding.why is not None
    assert finding.why.kept is not None
    return finding.why.kept


def pose_at(preview: Preview, frame: int) -> list[list[int]]:
    """Of each agent; one that never changes has one pose."""
    return [way[at : at + 5] for way in preview.ways for at in [5 * frame if len(way) > 5 else 0]]


def test_a_robot_that_waits_at_the_moment_that_decided_keeps_it(uncounted: tuple[PreparedRun, Finding]) -> None:
    prepared, finding = uncounted
    kept = kept_of(finding)
    assert finding.why is not None
    assert finding.confirmed is not None
    assert (kept.delayed, kept.tick, kept.seed) == ("carrier-2", finding.why.tick, finding.confirmed.seed)
    assert [fault.kind for fault in kept.faults] == [FailureKind.STALL, FailureKind.REVIVE]
    assert kept.delay == kept.faults[1].tick - kept.faults[0].tick > 0
    assert kept.ends_well
    run = prepared.spec.simulation(kept.seed)
    judged = judge_run(finding.verdict.property, run, kept.faults, lambda: False)
    assert judged.is_broken is False
    assert run.outcome == "done"


def test_both_are_the_same_up_to_there_and_the_schedule_of_a_mission_gives_the_run_that_was_judged(
    uncounted: tuple[PreparedRun, Finding],
) -> None:
    prepared, finding = uncounted
    kept, confirmed = kept_of(finding), finding.confirmed
    assert confirmed is not None
    fresh = prepared.spec.simulation
    first, last, tick_s = kept.tick - 20, confirmed.tick, fresh().tick_ms / 1000
    broken, _ = record_stretch(fresh(kept.seed), first, last, 1)
    failures = [Failure(one.agent, one.tick * tick_s, FailureKind(one.kind)) for one in kept.faults]
    opened = prepared.opened
    scheduled = replace(opened, mission=replace(opened.mission, failures=failures))
    other, events = record_stretch(scheduled.prepare(RunOptions(kept.seed, 600.0)).simulation, first, last, 1)
    assert broken.frames == other.frames == last - first + 1
    together = [pose_at(broken, frame) == pose_at(other, frame) for frame in range(broken.frames)]
    assert together[:20] == [True] * 20
    assert not together[-1]
    assert all(event.tick >= first for event in events)
    by_hand = fresh(kept.seed)
    left = list(kept.faults)
    while by_hand.tick < last:
        while left and left[0].tick <= by_hand.tick:
            fault = left.pop(0)
            by_hand.inject_fault(fault.agent, fault.kind)
        by_hand.advance(1)
    poses = [[round(x), round(y), round(turn * 1000), load] for x, y, turn, load, _ in by_hand.poses()]
    assert poses == [pose[:4] for pose in pose_at(other, other.frames - 1)]


def test_where_no_wait_helps_there_is_another_way_of_the_model_alone() -> None:
    """A wall would have to be there, for the button to be pressed."""
    program = "WAIT(1); <!(Button.IsPressed())>( WAIT(1); Count.Set(2); );"
    asked = AskedProperty("two", Form.NEVER, "any a (Count.EqualTo(2))")
    options = VerificationOptions((), (Timing.LOCKSTEP,), seconds=None, explains=True, asked=(asked,))
    finding = verify_runs(lambda seed: robots(a=program), 1, options).columns[0].findings[-1]
    assert finding.confirmed is not None
    assert finding.why is not None
    assert finding.why.other is not None
    assert finding.why.kept is None
    assert finding.why.to_json(20)["kept"] is None


def test_a_search_that_is_stopped_finds_none(uncounted: tuple[PreparedRun, Finding]) -> None:
    prepared, finding = uncounted
    assert finding.confirmed is not None
    fresh, moment = prepared.spec.simulation, kept_of(finding).tick
    one = finding.verdict.property
    assert find_kept_run(one, finding.confirmed, moment, ("carrier-2",), fresh, lambda: True) is None
    assert find_kept_run(one, finding.confirmed, moment, (), fresh, lambda: False) is None, "nobody is to wait"


def test_a_robot_waits_earlier_where_the_moment_itself_is_too_late(uncounted: tuple[PreparedRun, Finding]) -> None:
    """The arm swings already when the box is found missing."""
    prepared, finding = uncounted
    confirmed = finding.confirmed
    assert confirmed is not None
    late = confirmed.tick - 1
    found = find_kept_run(
        finding.verdict.property, confirmed, late, ("loader",), prepared.spec.simulation, lambda: False
    )
    assert found is not None
    assert found.delayed == "loader"
    assert found.tick < late


def test_the_kept_run_is_told_in_plain_values_too(uncounted: tuple[PreparedRun, Finding]) -> None:
    kept = kept_of(uncounted[1]).to_json(20)
    assert kept["delayed"] == "carrier-2"
    assert kept["delay_seconds"] == pytest.approx(0.5)
    assert kept["ends_well"]
    assert [one["what"] for one in kept["failures"]] == ["stall", "revive"]
