"""Robots that lose their radio: what they knew is their own from then on, and nobody hears what they write."""

from __future__ import annotations

from pathlib import Path

import pytest

from kitrobot.checking.verification import VerificationOptions, verify, verify_runs
from kitrobot.checking.verification_result import Verification
from kitrobot.mission.trial import FailureKind
from kitrobot.verifier.exploration.budget import Budget
from kitrobot.verifier.exploration.exploration import explore
from kitrobot.verifier.model.abstraction import abstract_run
from kitrobot.verifier.model.model import Model
from kitrobot.verifier.model.timing import Timing
from kitrobot.verifier.properties.verdicts import Answer
from tests.sim.building import transport
from tests.verifier.check_fixtures import mutant
from tests.verifier.reference import exploration as plain_exploration
from tests.verifier.reference import model as plain_model
from tests.verifier.reference import timing as plain_timing

MUTE = (FailureKind.MUTE,)
LOCKSTEP = (Timing.LOCKSTEP,)
APART = (
    '  <property name="apart" never="any loader (Order.EqualTo(0)) &amp; any store-manager-A (Order.EqualTo(1))"/>\n'
)


def checked(kinds: tuple[FailureKind, ...], *properties: str, failures: int = 1) -> Verification:
    """The transport mission with one carrier and two boxes in lockstep."""
    options = VerificationOptions(properties, LOCKSTEP, failures, kinds, seconds=None)
    return verify_runs(lambda seed: transport(seed, stock=2, carriers=1, seconds=300), 1, options)


def test_a_loader_that_hears_nobody_is_waited_for_and_the_simulator_shows_it() -> None:
    made = checked(MUTE, "deadlock", "empty-storehouse", "empty-swing")
    alone, muted = ({one.verdict.property.name: one for one in column.findings} for column in made.columns)
    assert {one.verdict.answer for one in alone.values()} == {Answer.HOLDS}
    # Who knows of too few boxes loads too few of them, never one that is not there.
    assert muted["empty-storehouse"].verdict.answer is muted["empty-swing"].verdict.answer is Answer.HOLDS
    broken = muted["deadlock"]
    assert broken.verdict.answer is Answer.BROKEN
    assert "loader loses its radio" in [str(text) for _, text in broken.story]
    assert broken.confirmed is not None
    assert [(harm.agent, harm.kind) for harm in broken.confirmed.faults] == [("loader", "mute")]
    assert [column.judged.states for column in made.columns] == [35, 468]
    assert [check["kinds"] for check in made.to_json()["checks"]] == [[], ["mute"]]
    assert [str(limit) for limit in made.limits] == ["a robot that loses its radio is taken never to have it again"]


@pytest.mark.parametrize("kind", [FailureKind.MUTE, FailureKind.FAIL])
def test_a_property_asks_for_what_a_robot_that_hears_nobody_knows(tmp_path: Path, kind: FailureKind) -> None:
    made = verify(
        mutant(tmp_path, ("  <world", f"{APART}  <world"), carriers=1, stock=1),
        VerificationOptions(("apart",), LOCKSTEP, 1, (kind,), seconds=None),
    )
    alone, befallen = (column.findings[0] for column in made.columns)
    assert alone.verdict.answer is Answer.HOLDS
    assert befallen.verdict.answer is Answer.BROKEN
    assert befallen.confirmed is not None
    assert [(harm.agent, harm.kind) for harm in befallen.confirmed.faults] == [("loader", kind.value)]


def test_what_is_asked_of_robots_that_fail_has_the_states_of_the_plain_model() -> None:
    run, kinds = transport(stock=1, carriers=1), (FailureKind.FAIL, FailureKind.MUTE)
    parts = abstract_run(run, {"Order"})
    ours = explore(Model(run, parts, 1, Timing.LOCKSTEP, kinds), Budget(), False)
    clock = plain_timing.Clock(plain_model.Model(run, parts, 1, kinds), plain_timing.Timing.LOCKSTEP)
    theirs = plain_exploration.explore(clock, plain_exploration.Budget(), lambda *_: True, False)
    assert (
        len(ours) == len(theirs.states) > len(explore(Model(run, abstract_run(run), 1, kinds=kinds), Budget(), False))
    )
