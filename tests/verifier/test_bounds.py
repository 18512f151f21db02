"""What is too large to be looked at whole has its answer in bounded memory and work."""

from __future__ import annotations

import itertools
import tracemalloc

import pytest

from kitrobot.exercise.exercise_xml import PROPERTIES
from kitrobot.mission.property_forms import READY, READY_OF_AGENTS, is_ready
from kitrobot.sim.simulation import Simulation
from kitrobot.verifier.exploration import exploration
from kitrobot.verifier.exploration.budget import Budget, CutReason
from kitrobot.verifier.exploration.engines import PLAIN
from kitrobot.verifier.model.abstraction import abstract_run
from kitrobot.verifier.model.model import Model
from kitrobot.verifier.model.programs import AbstractionError
from kitrobot.verifier.model.timing import Timing
from kitrobot.verifier.properties.properties import ready_properties
from kitrobot.verifier.properties.verdicts import check_properties
from kitrobot.verifier.tables.events import ModelTooLargeError
from tests.sim.building import avatar, empty_world, run_of, transport
from tests.verifier.check_fixtures import EXAMPLES, prepared

KEY = '<sensor name="Key" device="button" type="boolean"><operation name="IsPressed" test="equal" to="1"/></sensor>'
LEVEL = """<sensor name="Level" device="range" min="0" max="65535"><operation name="Value" value="yes"/></sensor>
<variable name="Seen" type="integer" min="0" max="65535"/>"""
COUNT = '<variable name="Count" type="integer" min="0" max="99"/>'


def alone(count: int, parts: str, text: str) -> Simulation:
    """So many robots in the empty room, each with these parts and this program."""
    names = [f"robot-{number}" for number in range(1, count + 1)]
    world = empty_world(**{name: (300.0 * number, 300, 0) for number, name in enumerate(names, 1)})
    return run_of({name: (avatar(parts, name=name), text) for name in names}, world)


@pytest.mark.parametrize("timing", Timing)
def test_six_robots_that_each_count_to_a_hundred_have_a_million_million_states_and_end_in_an_answer(
    timing: Timing,
) -> None:
    run = alone(6, KEY + COUNT, "*[Count.LessThan(99)]( [Key.IsPressed()]( Count.Add(1); ); );")
    model = Model(run, abstract_run(run), 0, timing)
    made = check_properties(model, ready_properties(model), Budget(5_000))
    assert not made.complete
    assert 4_000 < made.states <= 5_000
    assert made.memory < 11_000_000
    assert {verdict.answer.value for verdict in made.verdicts} == {"not finished"}


def beyond(_: Model, code: int) -> None:
    raise ModelTooLargeError(code)


@pytest.mark.parametrize(
    ("budget", "cut"),
    [
        (Budget(50), CutReason.STATES),
        (Budget(None, memory=1_000_000), CutReason.MEMORY),
        (Budget(None, seconds=40.0, clock=itertools.count().__next__), CutReason.TIME),
        (Budget(None, stop=lambda: True), CutReason.STOPPED),
        (Budget(None), CutReason.SIZE),
    ],
)
def test_why_a_search_ended_is_known(monkeypatch: pytest.MonkeyPatch, budget: Budget, cut: CutReason) -> None:
    run = transport(stock=12, carriers=3)
    model = Model(run, abstract_run(run), 0, Timing.FREE)
    model.begin()
    if cut is CutReason.SIZE:
        monkeypatch.setattr(Model, "fill", beyond)
    made = check_properties(model, ready_properties(model), budget, PLAIN)
    assert (made.cut, made.complete) == (cut, False)
    assert "holds" not in {verdict.answer.value for verdict in made.verdicts}


def test_a_check_takes_no_more_memory_than_it_may_growing_and_judging_included(monkeypatch: pytest.MonkeyPatch) -> None:
    """What Python allocates stands for what the process takes; a system gives pages, and not as exactly."""
    run = transport(stock=12, carriers=3)
    parts = abstract_run(run)
    tracemalloc.start()
    try:
        monkeypatch.setattr(exploration, "resident", lambda: tracemalloc.get_traced_memory()[0])
        model = Model(run, parts, 0, Timing.FREE)
        most = tracemalloc.get_traced_memory()[0] + 1_200_000
        ready = [one for one in ready_properties(model) if one.name in ("deadlock", "delivered")]
        made = check_properties(model, ready, Budget(None, memory=most), PLAIN)
        _, peak = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert made.cut is CutReason.MEMORY
    assert made.states > 1_000
    assert peak < most + 250_000


def test_of_what_is_seen_whole_nothing_is_cut() -> None:
    run = transport(stock=1, carriers=1)
    model = Model(run, abstract_run(run), 0, Timing.LOCKSTEP)
    made = check_properties(model, ready_properties(model), Budget(None), PLAIN)
    assert (made.cut, made.complete) == (None, True)


@pytest.mark.parametrize("timing", Timing)
def test_a_sensor_of_65536_values_that_is_copied_into_a_variable_is_refused_with_a_way_out(timing: Timing) -> None:
    run = alone(1, LEVEL, "*[Seen.LessThan(60000)]( Seen.Set(Level.Value()); );")
    model = Model(run, abstract_run(run), 0, timing)
    with pytest.raises(AbstractionError, match="`robot-1` may read too many different values") as refused:
        check_properties(model, ready_properties(model), Budget())
    assert "compare a sensor with numbers" in refused.value.help


def test_the_names_of_ready_properties_are_the_same_everywhere() -> None:
    """The mission's file keeps them for no others, exercises ask for them; both lie below the verifier."""
    run = transport(stock=1, carriers=2)
    names = {one.name for one in ready_properties(Model(run, abstract_run(run)))}
    served = {"served-carrier-1", "served-carrier-2"}
    assert {name for name in names if name not in READY} == served
    team = prepared(EXAMPLES / "exchange" / "exchange.krt").again()
    more = {one.name for one in ready_properties(Model(team, abstract_run(team)))}
    assert {name.partition("-")[0] for name in more if name not in READY} == {"meets"}
    assert all(is_ready(name) for name in names | more)
    assert not is_ready("meetsome")
    assert set(PROPERTIES) == {*READY, *READY_OF_AGENTS}
