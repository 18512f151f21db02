"""A check whose time is up: what was found is kept, the rest is *not finished*, and it ends.

No clock decides here: time goes on by a little each time somebody asks for it.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from kitrobot.checking.verification import VerificationOptions, verify
from kitrobot.sim.simulation import Simulation
from kitrobot.text.sentences import Sentence
from kitrobot.verifier.exploration.budget import Budget, CutReason
from kitrobot.verifier.exploration.engines import PLAIN
from kitrobot.verifier.exploration.exploration import explore
from kitrobot.verifier.model.abstraction import abstract_run
from kitrobot.verifier.model.model import Model
from kitrobot.verifier.model.timing import Timing
from kitrobot.verifier.properties import fair_cycles
from kitrobot.verifier.properties.properties import AgentFact, Property, ready_properties
from kitrobot.verifier.properties.verdicts import Counterexample, check_properties
from kitrobot.verifier.report.replay import ConfirmedRun, confirm
from tests.sim.building import transport
from tests.verifier.check_fixtures import EXAMPLES, answers, mutant, prepared

STEP_S, ENOUGH_S = 0.4, 400.0


class Clock:
    """Time that goes on by `STEP_S` when it is asked for."""

    def __init__(self) -> None:
        self.now = 0.0

    def __call__(self) -> float:
        self.now += STEP_S
        return self.now


def a_carrier_that_does_not_stop(folder: Path) -> Simulation:
    old = '<vertex id="v15" element="Wheel.Stop"/>'
    return mutant(folder, (old, '<vertex id="v15" element="Lamp.LightOn"/>'), carriers=2, stock=12).again()


@pytest.mark.parametrize("timing", Timing)
def test_what_was_found_is_kept_and_the_rest_is_not_finished(tmp_path: Path, timing: Timing) -> None:
    run = a_carrier_that_does_not_stop(tmp_path)
    model, clock = Model(run, abstract_run(run), 0, timing), Clock()
    properties = ready_properties(model)
    made = check_properties(model, properties, Budget(10_000_000, ENOUGH_S, clock=clock), PLAIN)
    assert not made.complete
    said = answers(made)
    assert list(said) == [one.name for one in properties]
    assert said.pop("contact") == "broken"
    assert {"not finished"} <= set(said.values()) <= {"not finished", "broken"}
    # Each property asks once more, at most, when time is up.
    assert clock.now < ENOUGH_S + STEP_S * (2 + 2 * len(properties))


def test_each_assumption_has_time_though_the_first_could_use_all_of_it() -> None:
    made = verify(
        prepared(EXAMPLES / "transport" / "transport.krt"), VerificationOptions(seconds=1000 * STEP_S, clock=Clock())
    )
    assert [column.judged.timing for column in made.columns] == list(Timing)
    assert {column.judged.cut for column in made.columns} == {CutReason.TIME}
    assert all(column.judged.states > 1 for column in made.columns)


def test_what_is_waited_for_has_a_share_of_the_time_and_is_not_searched_for_without_it() -> None:
    run = transport(stock=1, carriers=1)
    model, clock = Model(run, abstract_run(run), 0, Timing.LOCKSTEP), Clock()
    explored: list[float] = []
    whole = Budget(clock=clock, progress=lambda states, depth: explored.append(clock.now))
    assert set(answers(check_properties(model, ready_properties(model), whole, PLAIN)).values()) == {"holds"}
    took = explored[-1]
    for seconds in (took * 0.5, took * 4):
        model, clock = Model(run, abstract_run(run), 0, Timing.LOCKSTEP), Clock()
        made = check_properties(model, ready_properties(model), Budget(seconds=seconds, clock=clock), PLAIN)
        assert made.complete == (seconds > took)
        if not made.complete:
            assert made.cut is CutReason.TIME
            assert set(answers(made).values()) == {"not finished"}
    assert set(answers(made).values()) == {"holds"}


@pytest.mark.parametrize("which", ["mark_reachable", "find_crossing"])
def test_what_goes_through_all_states_is_broken_off_in_its_midst(monkeypatch: pytest.MonkeyPatch, which: str) -> None:
    """Without a clock: it is asked whether to break off after each piece, and says so after the third one."""
    monkeypatch.setattr(fair_cycles, "_STEPS", 50)
    monkeypatch.setattr(fair_cycles, "CHUNK", 50)
    run, calls, most = transport(stock=1, carriers=1), 0, 10_000

    def counting(*arguments: Any) -> int:
        nonlocal calls
        calls += 1
        return int(getattr(PLAIN, which)(*arguments))

    model = Model(run, abstract_run(run), 0, Timing.FREE)
    engine = (
        PLAIN._replace(mark_reachable=counting) if which == "mark_reachable" else PLAIN._replace(find_crossing=counting)
    )
    made = explore(model, Budget(), True, engine)
    made.interruption = lambda: CutReason.TIME if calls >= most else None
    ends = AgentFact(0, lambda inside: not model.has_ended(0, inside))
    nobody = AgentFact(0, lambda inside: False)
    one = Property("one", Sentence("one"), waits=((ends,),), breaks=(((ends,),), ((nobody,),)))

    def looked_through() -> bool:
        made.begin_property()
        if which == "mark_reachable":
            assert fair_cycles.find_fair_cycle(made, one) == ([], [])
        else:
            assert one.breaks is not None
            assert fair_cycles.find_first_crossing(made, *one.breaks) == (-1, -1)
        return made.interrupted_by is None

    assert looked_through()
    assert calls > 10
    calls, most = 0, 3
    assert not looked_through()
    assert made.interrupted_by is CutReason.TIME
    assert calls == 3


def test_a_run_of_the_simulator_is_given_up_in_its_midst(tmp_path: Path) -> None:
    runs: list[Simulation] = []

    def fresh(seed: int) -> Simulation:
        runs.append(transport(seed, stock=12, carriers=3))
        return runs[-1]

    run = transport(stock=12, carriers=3)
    model = Model(run, abstract_run(run))
    [contact] = [one for one in ready_properties(model) if one.name == "contact"]
    asked = 0

    def stop() -> bool:
        nonlocal asked
        asked += 1
        return asked > 3

    nothing: ConfirmedRun | None = confirm(contact, Counterexample((model.begin(),), ()), model, fresh, stop)
    assert nothing is None
    assert len(runs) == 1
    assert 0 < runs[0].tick < 500
    assert runs[0].outcome is None


def test_a_whole_check_ends_soon_after_its_time(tmp_path: Path) -> None:
    old = '<vertex id="v15" element="Wheel.Stop"/>'
    prepared = mutant(tmp_path, (old, '<vertex id="v15" element="Lamp.LightOn"/>'), carriers=2, stock=12)
    clock, timings = Clock(), (Timing.PROMPT, Timing.FREE)
    made = verify(prepared, VerificationOptions((), timings, seconds=ENOUGH_S, states=10_000_000, clock=clock))
    found = {one.verdict.property.name: one.verdict.answer.value for one in made.columns[0].findings}
    assert found["contact"] == "broken"
    assert not any(column.judged.complete for column in made.columns)
    assert {answer.value for answer in made.answers} == {"broken", "not finished"}
    assert clock.now < ENOUGH_S + STEP_S * 60
