"""An approximate search: what it says is broken is broken, nothing is said to hold, and it ends in any memory."""

from __future__ import annotations

import random
from itertools import pairwise
from pathlib import Path

import pytest

from kitrobot.checking.verification import VerificationOptions, verify
from kitrobot.verifier.exploration import state_filter
from kitrobot.verifier.exploration.approximate_search import ApproximateSpace, explore_approximately
from kitrobot.verifier.exploration.budget import Budget, CutReason
from kitrobot.verifier.exploration.engines import PLAIN
from kitrobot.verifier.exploration.exploration import explore
from kitrobot.verifier.model.abstraction import abstract_run
from kitrobot.verifier.model.model import Model, State
from kitrobot.verifier.model.timing import Timing
from kitrobot.verifier.properties.approximate_verdicts import check_approximately, is_judged_approximately
from kitrobot.verifier.properties.custom_properties import build_custom_property, property_variables
from kitrobot.verifier.properties.properties import ready_properties
from kitrobot.verifier.properties.verdicts import Counterexample, check_properties
from tests.effort import cases, examples
from tests.sim.building import transport
from tests.verifier.check_fixtures import EXAMPLES, answers, prepared
from tests.verifier.test_explanations_of_random_missions import branching_run, random_property

BESIDE = PLAIN._replace(is_parallel=True)


def is_run(model: Model, run: Counterexample) -> bool:
    """Whether the steps of a counterexample are steps of the model from its first state."""
    space = explore(model, Budget(1), False, PLAIN)
    states = run.states
    return states[0] == space.state(0) and all(
        after in [state for state, _, _ in space.steps_from(before)] for before, after in pairwise(states)
    )


@pytest.mark.parametrize("seed", range(examples(6, 150)))
def test_what_it_says_of_random_missions_agrees_with_the_exact_search(seed: int) -> None:
    rng = random.Random(seed)
    run, texts = branching_run(rng)
    asked, timing, failures = random_property(rng), rng.choice(list(Timing)), rng.choice([0, 0, 1])
    parts = abstract_run(run, property_variables(run, [asked]))
    exact, rough = (Model(run, parts, failures, timing) for _ in range(2))
    properties = [*ready_properties(exact), build_custom_property(exact, asked)]
    whole = check_properties(exact, properties, Budget(3_000), PLAIN)
    judged = [*ready_properties(rough), build_custom_property(rough, asked)]
    cores = rng.choice([1, 3])
    found = check_approximately(rough, judged, Budget(3_000, cores=cores), BESIDE)
    assert found.is_approximate
    assert not found.complete
    for one, other in zip(whole.verdicts, found.verdicts, strict=True):
        said = other.answer.value
        assert said in ("broken", "nothing found" if is_judged_approximately(other.property) else "not decided"), texts
        if said == "broken":
            assert one.answer.value == "broken", texts
            assert other.counterexample is not None
            assert is_run(rough, other.counterexample)
        elif said == "nothing found" and whole.complete:
            assert one.answer.value in ("holds", "vacuous"), (texts, asked)


@pytest.mark.parametrize(
    ("timing", "failures", "cores"),
    cases(
        [(Timing.FREE, 0, 1), (Timing.LOCKSTEP, 1, 3)],
        [(Timing.PROMPT, 1, 2), (Timing.FREE, 1, 3), (Timing.LOCKSTEP, 0, 1)],
    ),
)
def test_with_room_it_reaches_what_the_exact_search_reaches_and_knows_a_way_to_each(
    timing: Timing, failures: int, cores: int
) -> None:
    run = transport(stock=1, carriers=1)
    parts, seen = abstract_run(run), list[State]()

    def judge(space: ApproximateSpace, first: int, end: int) -> None:
        assert first == len(seen)
        seen.extend(space.state(number) for number in range(first, end))
        for number in range(first, end, 97):
            way = space.way(number)
            assert (way[0], way[-1]) == (space.first, space.state(number))

    model = Model(run, parts, failures, timing)
    found = explore_approximately(model, Budget(4_000, cores=cores), judge, engine=BESIDE)
    whole = explore(Model(run, parts, failures, timing), Budget(4_000), False, PLAIN)
    # Numbers of parts of a state are given as they come up, and may be others.
    assert len(set(seen)) == len(found) == len(whole)
    assert found.depth == whole.depth
    assert found.odds < 1e-3


@pytest.mark.parametrize("memory", [0, 1, 64, 2_000])
def test_a_tiny_filter_misses_states_and_ends_with_honest_odds(memory: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(
        "kitrobot.verifier.exploration.approximate_search._filter_bytes", lambda budget: max(64, memory)
    )
    run = transport(stock=1, carriers=1)
    model = Model(run, abstract_run(run), 0, Timing.FREE)
    found = check_approximately(model, ready_properties(model), Budget(None), PLAIN)
    assert found.states < 1_666
    assert found.odds is not None
    assert found.odds > (1e-3 if memory == 2_000 else 0.2)
    assert set(answers(found).values()) == {"nothing found", "not decided"}


def test_without_memory_it_ends_at_once_and_says_why() -> None:
    run = transport(stock=12, carriers=3)
    model = Model(run, abstract_run(run), 0, Timing.FREE)
    found = check_approximately(model, ready_properties(model), Budget(None, memory=0), PLAIN)
    assert (found.cut, found.complete) == (CutReason.MEMORY, False)
    assert "holds" not in answers(found).values()


def test_a_mission_made_wrong_is_found_broken_and_confirmed_in_the_simulator(tmp_path: Path) -> None:
    text = (EXAMPLES / "passing-loop" / "passing-loop.krt").read_text(encoding="utf-8")
    few = '<vertex id="v1" element="Repetition"><set name="count">3</set>'
    path = tmp_path / "greedy.krt"
    path.write_text(text.replace(few, few.replace("3", "9")), encoding="utf-8")
    options = VerificationOptions(("empty-storehouse",), (Timing.LOCKSTEP,), seconds=None, approximate=True, cores=1)
    (found,) = verify(prepared(path), options).columns[0].findings
    assert found.verdict.answer.value == "broken"
    assert found.confirmed is not None
    assert found.confirmed.seed == 1


def test_what_is_broken_ends_the_search_when_nothing_else_is_asked() -> None:
    run = transport(stock=1, carriers=1)
    model = Model(run, abstract_run(run), 1, Timing.FREE)
    asked = [one for one in ready_properties(model) if one.name == "deadlock"]
    found = check_approximately(model, asked, Budget(1_000_000), PLAIN)
    assert answers(found) == {"deadlock": "broken"}
    assert found.states < 100_000
    assert found.cut is None


def test_nothing_is_explored_for_what_cannot_be_decided() -> None:
    run = transport(stock=1, carriers=1)
    model = Model(run, abstract_run(run))
    asked = [one for one in ready_properties(model) if one.name == "delivered"]
    found = check_approximately(model, asked, Budget(), PLAIN)
    assert (answers(found), found.states, found.odds) == ({"delivered": "not decided"}, 1, None)


def test_odds_are_the_share_of_new_hashes_that_a_filter_takes_for_old_ones() -> None:
    blocks, chance = 8, random.Random(1)
    bits = bytearray(blocks * state_filter.BLOCK)

    def is_new(h: int) -> bool:
        return state_filter.insert_hash(bits, state_filter.block_of(h, blocks), h) != state_filter.SEEN

    for _ in range(300):
        h = chance.getrandbits(63)
        is_new(h)
        assert not is_new(h)
    odds = state_filter.odds_of_omission(bits)
    kept, missed = bytes(bits), 0
    for _ in range(4_000):
        bits[:] = kept
        missed += not is_new(chance.getrandbits(63))
    assert missed / 4_000 == pytest.approx(odds, abs=4 * (odds / 4_000) ** 0.5)
