"""Several workers explore what one does: the same states and steps, number by number. The plain engine takes turns."""

from __future__ import annotations

import random

import pytest

from kitrobot.sim.simulation import Simulation
from kitrobot.verifier.exploration import batch_search
from kitrobot.verifier.exploration.budget import Budget, CutReason
from kitrobot.verifier.exploration.engines import PLAIN
from kitrobot.verifier.exploration.exploration import StateSpace, explore
from kitrobot.verifier.model.abstraction import abstract_run
from kitrobot.verifier.model.model import Model
from kitrobot.verifier.model.table_builder import KINDS
from kitrobot.verifier.model.timing import Timing
from kitrobot.verifier.properties.properties import ready_properties
from kitrobot.verifier.properties.verdicts import check_properties
from kitrobot.verifier.tables import columns as v
from tests.effort import cases, examples
from tests.sim.building import transport
from tests.verifier.check_fixtures import EXAMPLES, answers, prepared
from tests.verifier.test_explanations_of_random_missions import branching_run

BESIDE = PLAIN._replace(is_parallel=True)
"""The plain engine, as if its functions ran beside each other."""


def numbers(space: StateSpace) -> list[object]:
    """All that an exploration found, in its order."""
    graph, regs, count = space.graph, space.model.t.regs, len(space)
    found: list[object] = [count, space.expanded, space.depth, space.cut, space.first_occurrences()]
    found += [[space.state(number) for number in range(count)], list(graph.parents[:count])]
    found.append(list(graph.calm[: regs[v.CALMS]]))
    if regs[v.KEEPS]:
        edges = graph.first_edge[space.expanded]
        found += [list(graph.first_edge[: space.expanded + 1]), list(graph.targets[:edges]), list(graph.taken[:edges])]
    return found


def agree(
    run: Simulation, timing: Timing, failures: int = 0, states: int | None = None, cores: int = 2, keeps: bool = True
) -> StateSpace:
    """One worker and several find the same."""
    parts = abstract_run(run)
    alone = explore(Model(run, parts, failures, timing, KINDS), Budget(states), keeps, PLAIN)
    budget = Budget(states, cores=cores, alone=0)
    together = explore(Model(run, parts, failures, timing, KINDS), budget, keeps, BESIDE)
    assert together.batches is not None
    assert numbers(alone) == numbers(together)
    return together


@pytest.mark.parametrize(
    ("carriers", "timing", "failures", "states"),
    cases(
        [(1, Timing.FREE, 0, None), (1, Timing.LOCKSTEP, 1, None)],
        [(1, Timing.FREE, 1, 30_000), (2, Timing.PROMPT, 0, None), (2, Timing.LOCKSTEP, 0, None)],
    ),
)
@pytest.mark.parametrize("cores", [2, 3])
def test_workers_find_the_same_states_and_steps_in_the_same_order(
    carriers: int, timing: Timing, failures: int, states: int | None, cores: int
) -> None:
    agree(transport(stock=1, carriers=carriers), timing, failures, states, cores)


@pytest.mark.parametrize("name", cases(["passing-loop"], ["exchange", "merge", "crossing", "sumo"]))
def test_workers_agree_with_one_on_missions_that_come_with_it(name: str) -> None:
    agree(prepared(EXAMPLES / name / f"{name}.krt").again(), Timing.LOCKSTEP, states=2_000)


@pytest.mark.parametrize("seed", range(examples(4, 60)))
def test_workers_agree_with_one_on_random_missions(seed: int) -> None:
    rng = random.Random(seed)
    run, texts = branching_run(rng)
    timing, cores = rng.choice(list(Timing)), rng.choice([2, 3, 5])
    assert len(agree(run, timing, rng.choice([0, 1]), 2_000, cores, rng.random() < 0.5)), texts


def test_a_limit_of_states_is_kept_and_ends_at_the_same_state() -> None:
    found = agree(transport(stock=1, carriers=1), Timing.FREE, states=777)
    assert (len(found), found.cut) == (777, CutReason.STATES)


def test_a_batch_without_room_for_its_steps_begins_anew(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(batch_search, "_STATES", 16)
    monkeypatch.setattr(batch_search, "_STEPS_EACH", 1)
    monkeypatch.setattr(batch_search, "_MOST_STEPS", 32)
    agree(transport(stock=1, carriers=1), Timing.FREE)
    agree(transport(stock=1, carriers=1), Timing.LOCKSTEP, failures=1)


def test_workers_give_the_answers_of_one_and_small_missions_have_one() -> None:
    run = transport(stock=1, carriers=1)

    def judged(budget: Budget) -> dict[str, str]:
        model = Model(run, abstract_run(run), 1, Timing.LOCKSTEP)
        return answers(check_properties(model, ready_properties(model), budget, BESIDE))

    assert judged(Budget(cores=3, alone=0)) == judged(Budget())
    small = explore(Model(run, abstract_run(run)), Budget(cores=2), False, BESIDE)
    assert small.batches is None
