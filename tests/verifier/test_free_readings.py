"""Sensors that are taken to read anything: they are named with the answer, and so is what they read in a run."""

from __future__ import annotations

import pytest

from kitrobot.checking.verification import VerificationOptions, verify_runs
from kitrobot.checking.verification_result import Verification
from kitrobot.sim.simulation import Simulation
from kitrobot.translation.translator import translate_to
from kitrobot.verifier.model.abstraction import abstract_run
from kitrobot.verifier.model.timing import Timing
from tests.sim.building import avatar, empty_world, run_of

GROUND = """<sensor name="Ground" device="colour" min="0" max="9">
  <operation name="EqualTo" test="equal"><parameter name="value" min="0" max="9"/></operation>
</sensor>"""
HAND = '<sensor name="Hand" device="key" type="boolean"><operation name="IsPressed" test="equal" to="1"/></sensor>'
FLAG = '<variable name="Flag" type="boolean" initial="false" shared="yes"/>'
WAITS = "[Ground.EqualTo(7)]( WAIT(2); <Flag.IsTrue()>(); );"


def checked(text: str, timing: Timing = Timing.LOCKSTEP, ground: str = GROUND) -> Verification:
    robot = avatar(ground, FLAG)

    def fresh(seed: int) -> Simulation:
        world = empty_world(a=(200.0, 200.0, 0.0), b=(600.0, 600.0, 0.0))
        return run_of({"a": (robot, text), "b": (robot, "WAIT(1);")}, world, seed=seed)

    return verify_runs(fresh, 1, VerificationOptions(("deadlock",), (timing,), seconds=None))


@pytest.mark.parametrize("timing", Timing)
def test_a_run_that_needs_a_reading_which_never_comes_is_told_with_it_and_is_not_reproduced(timing: Timing) -> None:
    made = checked(WAITS, timing)
    assert [str(limit) for limit in made.limits] == ["Ground of a is taken to read anything at any time"]
    [finding] = made.columns[0].findings
    assert finding.verdict.answer.value == "broken"
    assert finding.searched
    assert finding.confirmed is None
    told = [str(text) for _, text in finding.story]
    assert told[-3:] == [
        "a reads Ground = 7",
        "a waits",
        "this run needs readings that may never come so: a: Ground",
    ]


def test_a_run_that_reads_what_is_there_is_confirmed_and_needs_nothing() -> None:
    made = checked("<Flag.IsTrue()>();")
    [finding] = made.columns[0].findings
    assert made.limits == ()
    assert finding.confirmed is not None
    assert [str(text) for _, text in finding.story] == ["a waits"]


def test_what_a_person_presses_may_come_at_any_time_and_is_no_limit() -> None:
    robot = avatar(HAND)
    world = empty_world(a=(200.0, 200.0, 0.0))
    assert abstract_run(run_of({"a": (robot, "<Hand.IsPressed()>();")}, world)).limits == []
    assert abstract_run(run_of({"a": (avatar(GROUND), "WAIT(2);")}, world)).limits == []


SEEN = """<sensor name="Ground" device="colour" min="0" max="9" unit="%">
  <label>Light below</label><label xml:lang="fr">Lumière dessous</label>
  <choice value="7"><label>red</label><label xml:lang="fr">rouge</label></choice>
  <operation name="EqualTo" test="equal"><parameter name="value" min="0" max="9"/></operation>
</sensor>"""


@pytest.mark.parametrize(
    ("wanted", "english", "french"),
    [(7, "a reads Light below = red", "a lit Lumière dessous = rouge"), (3, "a reads Light below = 3 %", "= 3 %")],
)
def test_a_reading_is_told_as_the_palette_names_it_with_its_unit_or_choice(
    wanted: int, english: str, french: str
) -> None:
    made = checked(f"[Ground.EqualTo({wanted})]( WAIT(2); <Flag.IsTrue()>(); );", ground=SEEN)
    [finding] = made.columns[0].findings
    *_, reads, _, needs = (text for _, text in finding.story)
    assert str(reads) == english
    assert translate_to(reads, "fr").endswith(french)
    assert str(needs).endswith(": a: Light below")
    assert str(made.limits[0]).startswith("Light below of a")
