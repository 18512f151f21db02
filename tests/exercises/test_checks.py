"""Goals of checking: what an exact search does not finish is looked for approximately, in words that claim no more."""

from __future__ import annotations

import pytest

from kitrobot.checking.check_evidence import FURTHER, collect_check_evidence
from kitrobot.exercise.evidence import CheckEvidence
from kitrobot.exercise.goals import CheckGoal
from kitrobot.workspace.mission_run import PreparedRun
from tests.verifier.check_fixtures import mutant

STOPS = '<vertex id="v15" element="Wheel.Stop"/>'


@pytest.fixture(scope="module")
def jammed(tmp_path_factory: pytest.TempPathFactory) -> PreparedRun:
    """Carriers that do not stop behind each other: 856 states, at whose end nothing moves."""
    return mutant(tmp_path_factory.mktemp("jammed"), (STOPS, STOPS.replace("Wheel.Stop", "Lamp.LightOn")))


def goal(name: str, states: int, approximate: bool = False) -> CheckGoal:
    return CheckGoal({"": name}, 1, False, name, "lockstep", 0, states, approximate)


def seen(run: PreparedRun, *goals: CheckGoal) -> dict[str, CheckEvidence]:
    return collect_check_evidence(run, goals)


def test_what_lies_behind_the_cut_of_an_exact_search_is_found_approximately(jammed: PreparedRun) -> None:
    found = seen(jammed, goal("deadlock", 300), goal("contact", 300), goal("delivered", 300))
    assert found["deadlock"].answer == "broken"
    assert 300 < found["deadlock"].states <= FURTHER * 300
    assert found["deadlock"].steps == seen(jammed, goal("deadlock", 1000))["deadlock"].steps
    assert "waits" in str(goal("deadlock", 300).fault(found["deadlock"]).sentence)  # type: ignore[union-attr]
    # The first search had found this one, and an approximate one cannot judge that one.
    assert (found["contact"].answer, found["contact"].states) == ("broken", 300)
    assert (found["delivered"].answer, found["delivered"].states) == ("not finished", 300)


def test_that_nothing_was_found_is_no_proof_and_counts_where_the_goal_says_so(jammed: PreparedRun) -> None:
    found = seen(jammed, goal("deadlock", 100))["deadlock"]
    assert (found.answer, found.states) == ("nothing found", FURTHER * 100)
    fault = goal("deadlock", 100).fault(found)
    assert fault is not None
    assert "not proved; nothing was found in 400 states" in fault.sentence
    assert goal("deadlock", 100, approximate=True).fault(found) is None


def test_a_search_that_is_stopped_is_not_gone_on_with(jammed: PreparedRun) -> None:
    found = collect_check_evidence(jammed, [goal("deadlock", 100)], lambda: True)["deadlock"]
    assert found.answer == "not finished"
    assert found.states <= 100
