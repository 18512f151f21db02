"""Why a property broke: what is needed for it, when it was decided, and what would have avoided it."""

from __future__ import annotations

from pathlib import Path

import pytest

from kitrobot.checking.verification import VerificationOptions, verify, verify_runs
from kitrobot.checking.verification_result import Finding
from kitrobot.mission.property_forms import AskedProperty, Form
from kitrobot.sim.simulation import Simulation
from kitrobot.verifier.exploration.budget import Budget
from kitrobot.verifier.exploration.engines import ArrayTables
from kitrobot.verifier.model.abstraction import abstract_run
from kitrobot.verifier.model.model import Model
from kitrobot.verifier.model.timing import Timing
from kitrobot.verifier.properties.custom_properties import build_custom_property, property_variables
from kitrobot.verifier.properties.properties import ready_properties
from kitrobot.verifier.properties.verdicts import check_properties
from kitrobot.verifier.report.avoidance import Avoidance, Certainty
from kitrobot.verifier.report.explanation import explain_run
from kitrobot.verifier.report.explanation_text import describe_explanation
from kitrobot.verifier.report.minimization import events_of
from kitrobot.verifier.tables.motion import Move
from tests.sim.building import empty_world, run_of
from tests.verifier.check_fixtures import mutant
from tests.verifier.test_brute_force import ROBOT
from tests.verifier.test_known_answers import FALL, UNCOUNTED


def robots(**programs: str) -> Simulation:
    """Robots with a button each and these programs, which share `Flag` and `Count`."""
    places = {name: (200.0 + 300 * number, 600.0, 0.0) for number, name in enumerate(programs)}
    return run_of({name: (ROBOT, text) for name, text in programs.items()}, empty_world(**places), seconds=20.0)


def explained(run: Simulation, timing: Timing, *asked: AskedProperty, name: str = "", failures: int = 0) -> Finding:
    """The last finding about one property, with why it is broken; the simulator is not asked."""
    names = (name,) if name else ()
    options = VerificationOptions(names, (timing,), failures, seconds=None, confirms=False, explains=True, asked=asked)
    found = verify_runs(lambda seed: run, 1, options).columns[-1].findings[-1]
    assert found.why is not None
    assert len(found.why.sentences) <= 3
    return found


def sentences(finding: Finding) -> list[str]:
    assert finding.why is not None
    return [str(one) for one in finding.why.sentences]


NEVER_TWO = AskedProperty("two", Form.NEVER, "any a (Count.EqualTo(2))")


def test_the_reading_that_decides_is_named_and_so_is_the_other_one() -> None:
    run = robots(a="WAIT(1); [Button.IsPressed()]( WAIT(1); Count.Set(2); );")
    found = explained(run, Timing.LOCKSTEP, NEVER_TWO)
    assert found.why is not None
    assert found.why.certainty is Certainty.LAST
    told = sentences(found)
    assert told[1] == "this decides it: a reads Button = true"
    assert told[2] == "it does not break if this happens instead: a reads Button = false"
    # What comes after it changes nothing any more.
    counterexample = found.verdict.counterexample
    assert counterexample is not None
    assert found.why.step < len(counterexample.steps) - 1
    assert found.why.other is not None
    assert found.why.other.ends_well


def test_where_every_order_breaks_it_nothing_could_have_avoided_it() -> None:
    found = explained(robots(a="WAIT(1); Count.Set(2);", b="Flag.Set(1);"), Timing.FREE, NEVER_TWO)
    assert found.why is not None
    assert found.why.certainty is Certainty.NEVER
    assert (found.why.step, found.why.other) == (-1, None)
    assert sentences(found)[1].startswith("every order of events breaks it")


def test_the_one_who_comes_first_decides() -> None:
    """Two that look whether they are the first: whoever lags after it has looked comes second all the same."""
    first = "WAIT(1); <Flag.IsFalse()>( WAIT(1); Flag.Set(1); Count.Add(1); );"
    found = explained(robots(a=first, b=first), Timing.FREE, NEVER_TWO)
    assert found.why is not None
    assert found.why.certainty is Certainty.LAST
    assert "goes on in its program" in sentences(found)[1]
    assert "goes on in its program" in sentences(found)[2]


def test_a_failure_that_is_not_needed_is_left_out() -> None:
    """With it the property breaks sooner, but it breaks without it too."""
    run = robots(
        a="WAIT(1); *[Flag.IsTrue()]( WAIT(1); ); Count.Set(2);",
        b="Flag.Set(1); WAIT(3); Flag.Set(0);",
    )
    found = explained(run, Timing.LOCKSTEP, NEVER_TWO, failures=1)
    counterexample = found.verdict.counterexample
    assert found.why is not None
    assert counterexample is not None
    assert events_of(counterexample.steps) == []
    assert found.why.left_out > 0
    assert found.why.certainty is Certainty.NEVER


def test_a_failure_that_is_needed_decides(tmp_path: Path) -> None:
    made = verify(
        mutant(tmp_path, stock=1, carriers=1),
        VerificationOptions(("deadlock",), (Timing.LOCKSTEP,), failures=1, seconds=None, explains=True),
    )
    found = made.columns[-1].findings[0]
    assert found.why is not None
    assert found.confirmed is not None
    assert sentences(found)[2] == "it does not break without that failure"
    assert found.why.tick == found.confirmed.faults[0].tick
    assert found.why.kept is not None
    assert (found.why.kept.faults, found.why.kept.delayed) == ((), "")
    assert found.why.kept.tick == found.why.tick
    assert found.why.kept.ends_well


def test_the_stem_of_a_wait_in_vain_has_no_more_than_it_needs(tmp_path: Path) -> None:
    run = mutant(tmp_path, FALL, carriers=1, stock=2).again()
    found = explained(run, Timing.FREE, name="end")
    assert found.why is not None
    assert found.why.left_out > 10
    assert sentences(found)[0].startswith("nothing happens any more: carrier-1, loader")
    assert sentences(found)[2].startswith("it does not break if this comes first: loader goes on in its program")


def test_a_loop_that_can_be_left_at_any_time_is_never_too_late() -> None:
    """Whoever presses the button ends it; nobody need."""
    run = robots(a="*[!(Button.IsPressed())]( WAIT(1); ); Count.Set(1);")
    ends = AskedProperty("ends", Form.EVENTUALLY, "any a (Count.EqualTo(1))")
    found = explained(run, Timing.LOCKSTEP, ends)
    assert found.why is not None
    assert found.why.certainty is Certainty.ALWAYS
    assert sentences(found)[1] == "it is never too late: what is waited for can still come"
    assert sentences(found)[2] == "it comes after this: a reads Button = true"


def test_the_moment_is_found_again_in_the_run_of_the_simulator(tmp_path: Path) -> None:
    made = verify(
        mutant(tmp_path, UNCOUNTED, stock=1),
        VerificationOptions(("empty-storehouse",), (Timing.LOCKSTEP,), seconds=None, explains=True, draws=True),
    )
    found = made.columns[0].findings[0]
    assert found.why is not None
    assert found.confirmed is not None
    assert 0 < found.why.tick < found.confirmed.tick
    assert "carrier-2 comes to ring 0–80 mm" in sentences(found)[1]
    assert found.why.other is not None
    assert found.why.other.scenes[0].step == found.why.step
    assert any(step == found.why.step for step, _ in found.story)
    told = made.to_json()["checks"][0]["properties"][0]["why"]
    assert told["sentences"] == sentences(found)
    assert told["seconds"] == found.why.tick * made.tick_ms / 1000
    assert told["other_way"]["ends_well"]


@pytest.mark.parametrize("calls", [0, 40, 100_000])
def test_what_was_not_looked_at_in_time_is_not_claimed(calls: int) -> None:
    """Time is up as soon as the explanation begins, or soon after: what is said then is that the search ended."""
    run = robots(a="WAIT(1); [Button.IsPressed()]( WAIT(1); Count.Set(2); );")
    model = Model(run, abstract_run(run, property_variables(run, [NEVER_TWO])))
    one = build_custom_property(model, NEVER_TWO)
    made = check_properties(model, [one], Budget(1_000))
    found = made.verdicts[0].counterexample
    assert found is not None
    asked = 0

    def stop() -> bool:
        nonlocal asked
        asked += 1
        return asked > calls

    told = explain_run(model, one, found, made.states, Budget(stop=stop))
    assert told is not None
    words = [str(sentence) for sentence in describe_explanation(model, one, told.run, told.avoidance)]
    if calls == 0:
        assert told.run == found
        assert told.avoidance == Avoidance(Certainty.UNKNOWN)
        assert words[1:] == ["the search ended before it knew whether it could be avoided: more time may tell"]
    if calls == 100_000:
        assert words[1] == "this decides it: a reads Button = true"


def test_in_a_mission_too_large_to_look_at_a_walk_shows_that_it_could_be_avoided(tmp_path: Path) -> None:
    stop = '<vertex id="v15" element="Wheel.Stop"/>'
    run = mutant(tmp_path, (stop, stop.replace("Wheel.Stop", "Lamp.LightOn")), carriers=3, stock=4).again()
    model = Model(run, abstract_run(run), 0, Timing.PROMPT)
    [contact] = [one for one in ready_properties(model) if one.name == "contact"]
    found = check_properties(model, [contact], Budget(2_000)).verdicts[0].counterexample
    assert found is not None
    told = explain_run(model, contact, found, None, Budget(100))
    assert told is not None
    avoidance = told.avoidance
    assert (avoidance.certainty, avoidance.step) == (Certainty.LAST, len(told.run.steps) - 1)
    assert avoidance.ends_well
    other = avoidance.other
    assert other is not None
    assert other.states[: avoidance.step + 1] == told.run.states[: avoidance.step + 1]
    assert all(event.what is not Move.TOUCH for event in events_of(other.steps))
    assert model.goals_hold(model.shareds()[other.states[-1][0]])


def test_tables_of_compiled_functions_are_taken_back() -> None:
    """A check that was compiled leaves arrays, of which the explanation makes lists again."""
    numpy = pytest.importorskip("numpy")
    run = robots(a="WAIT(1); [Button.IsPressed()]( WAIT(1); Count.Set(2); );")
    model = Model(run, abstract_run(run, property_variables(run, [NEVER_TWO])))
    one = build_custom_property(model, NEVER_TWO)
    made = check_properties(model, [one], Budget(1_000))
    found = made.verdicts[0].counterexample
    assert found is not None
    model.t = ArrayTables(*(numpy.array(table, numpy.int64) for table in model.t))
    told = explain_run(model, one, found, made.states, Budget())
    assert told is not None
    assert told.avoidance.certainty is Certainty.LAST
