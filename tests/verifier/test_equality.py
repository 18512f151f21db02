"""The explorer over tables against the plain model of tuples: the same states, depth, and answers."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import pytest

from kitrobot.mission.trial import FailureKind
from kitrobot.sim.simulation import Simulation
from kitrobot.verifier.exploration.budget import Budget
from kitrobot.verifier.exploration.exploration import explore
from kitrobot.verifier.model.abstraction import abstract_run
from kitrobot.verifier.model.model import Model
from kitrobot.verifier.model.programs import AbstractionError
from kitrobot.verifier.model.table_builder import USUAL_KINDS
from kitrobot.verifier.model.timing import Timing
from kitrobot.verifier.properties.properties import ready_properties
from kitrobot.verifier.properties.verdicts import check_properties
from kitrobot.verifier.tables import columns as v
from tests.effort import cases
from tests.sim.building import transport
from tests.verifier.check_fixtures import EXAMPLES, mutant, prepared
from tests.verifier.reference import exploration as plain_exploration
from tests.verifier.reference import model as plain_model
from tests.verifier.reference import properties as plain_properties
from tests.verifier.reference import timing as plain_timing
from tests.verifier.reference import verdicts as plain_verdicts


def agrees(run: Simulation, timing: Timing, failures: int = 0, kinds: Sequence[FailureKind] = USUAL_KINDS) -> None:
    """Explores a mission both ways and compares what came of it."""
    parts = abstract_run(run)
    model = Model(run, parts, failures, timing, kinds)
    ours = check_properties(model, ready_properties(model), Budget(200_000))
    plain = plain_model.Model(run, parts, failures, kinds)
    theirs = plain_verdicts.check_properties(
        plain,
        plain_properties.ready_properties(plain),
        plain_timing.Timing(timing.value),
        failures,
        plain_exploration.Budget(200_000),
    )
    assert ours.complete
    assert (ours.states, ours.complete) == (theirs.states, theirs.complete)
    is_as_short(ours.depth, theirs.depth, timing)
    verdicts = {one.property.name: one for one in ours.verdicts}
    for other in theirs.verdicts:
        one = verdicts[other.property.name]
        assert one.answer.value == other.answer.value
        if one.counterexample is not None and other.way is not None and one.property.waits is None:
            is_as_short(len(one.counterexample.steps), len(other.way.steps), timing)


def is_as_short(ours: int, theirs: int, timing: Timing) -> None:
    """In lockstep so many steps as in the plain model; else there may be fewer: of three agents and more the tables
    have ticks in one moment that one after another come to the same.
    """
    assert ours == theirs if timing is Timing.LOCKSTEP else 0 < ours <= theirs


@pytest.mark.parametrize(
    ("carriers", "stock", "timing", "failures"),
    cases(
        [
            (1, 1, Timing.FREE, 0),
            (2, 1, Timing.PROMPT, 0),
            (2, 2, Timing.LOCKSTEP, 0),
            (1, 1, Timing.PROMPT, 1),
            (1, 1, Timing.LOCKSTEP, 1),
        ],
        [(1, 1, Timing.FREE, 1), (2, 1, Timing.FREE, 0), (2, 1, Timing.LOCKSTEP, 1), (3, 3, Timing.LOCKSTEP, 0)],
    ),
)
def test_the_transport_mission_has_the_states_and_answers_of_the_plain_model(
    carriers: int, stock: int, timing: Timing, failures: int
) -> None:
    agrees(transport(stock=stock, carriers=carriers), timing, failures)


@pytest.mark.parametrize(
    ("timing", "failures", "kinds"),
    cases(
        [
            (Timing.LOCKSTEP, 1, (FailureKind.MUTE,)),
            (Timing.PROMPT, 1, (FailureKind.MUTE,)),
        ],
        [
            (Timing.LOCKSTEP, 2, (FailureKind.STALL, FailureKind.MUTE)),
            (Timing.FREE, 1, (FailureKind.MUTE,)),
            (Timing.PROMPT, 2, (FailureKind.STALL, FailureKind.MUTE)),
        ],
    ),
)
def test_robots_that_lose_their_radio_have_the_states_and_answers_of_the_plain_model(
    timing: Timing, failures: int, kinds: tuple[FailureKind, ...]
) -> None:
    agrees(transport(stock=1, carriers=1), timing, failures, kinds)


@pytest.mark.parametrize("timing", cases([Timing.LOCKSTEP], [Timing.PROMPT]))
def test_a_mission_made_wrong_is_broken_alike(tmp_path: Path, timing: Timing) -> None:
    old = '<vertex id="v15" element="Wheel.Stop"/>'
    agrees(mutant(tmp_path, (old, old.replace("Wheel.Stop", "Lamp.LightOn")), carriers=2, stock=1).again(), timing)


def test_a_mission_on_two_roads_has_the_states_and_answers_of_the_plain_model() -> None:
    agrees(prepared(EXAMPLES / "passing-loop" / "passing-loop.krt").again(), Timing.LOCKSTEP)


def test_keys_of_two_words_have_the_states_of_one() -> None:
    """A field that is far wider than it needs to be pushes others into the second word."""
    run = transport(stock=1, carriers=1)
    narrow = explore(Model(run, abstract_run(run), 0, Timing.FREE), Budget(), True)
    model = Model(run, abstract_run(run), 0, Timing.FREE)
    model.begin()
    for field in range(1, 4):
        model.layout = model.widths.widen(field, (1 << 20) - 1)
    model.place_fields()
    wide = explore(model, Budget(), True)
    assert (narrow.model.layout.words, wide.model.layout.words) == (1, 2)
    assert [narrow.state(n) for n in range(len(narrow))] == [wide.state(n) for n in range(len(wide))]
    assert list(narrow.graph.targets[:100]) == list(wide.graph.targets[:100])


def test_what_a_field_holds_no_more_widens_it_and_changes_no_state() -> None:
    run = transport(stock=1, carriers=1)
    made = explore(Model(run, abstract_run(run), 0, Timing.FREE), Budget(), False)
    states = [made.state(n) for n in range(len(made))]
    assert len(set(states)) == len(states) == 1666
    assert all(
        max(column) <= mask for column, mask in zip(zip(*states, strict=True), made.model.layout.mask, strict=True)
    )


@pytest.mark.parametrize("memory", [0, 500_000])
def test_a_search_without_memory_left_ends_and_nothing_holds(memory: int) -> None:
    run = transport(stock=12, carriers=3)
    model = Model(run, abstract_run(run), 0, Timing.FREE)
    made = check_properties(model, ready_properties(model), Budget(10_000_000, memory=memory))
    assert not made.complete
    assert made.memory < memory + 3_000_000
    assert "holds" not in {verdict.answer.value for verdict in made.verdicts}


def test_a_search_is_stopped_between_two_looks() -> None:
    run = transport(stock=12, carriers=3)
    asked = 0

    def stop() -> bool:
        nonlocal asked
        asked += 1
        return asked > 3

    told: list[int] = []
    made = explore(
        Model(run, abstract_run(run), 0, Timing.FREE),
        Budget(10_000_000, stop=stop, progress=lambda states, depth: told.append(states)),
        True,
    )
    assert not made.complete
    assert told[-1] == len(made) > 0
    assert int(made.model.t.regs[v.AT]) < len(made)


def test_too_many_robots_are_refused_in_a_sentence() -> None:
    run = transport(stock=1, carriers=1)
    parts = abstract_run(run)
    parts.parts = (parts.parts * 63)[:63]
    with pytest.raises(AbstractionError, match="too many robots"):
        Model(run, parts)
