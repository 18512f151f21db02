"""The compiled functions against the same source run by CPython: states, steps and answers, number by number.

Only in the thorough profile: compiling them takes a minute of processor time where they are not kept yet.
"""

from __future__ import annotations

import pytest

from kitrobot.mission.property_forms import AskedProperty, Form
from kitrobot.verifier.exploration.approximate_search import ApproximateSpace, explore_approximately
from kitrobot.verifier.exploration.budget import Budget
from kitrobot.verifier.exploration.engines import PLAIN, Engine
from kitrobot.verifier.exploration.exploration import StateSpace, explore
from kitrobot.verifier.exploration.numba_engine import engine
from kitrobot.verifier.model.abstraction import abstract_run
from kitrobot.verifier.model.model import Model
from kitrobot.verifier.model.table_builder import KINDS
from kitrobot.verifier.model.timing import Timing
from kitrobot.verifier.properties.custom_properties import build_custom_properties, property_variables
from kitrobot.verifier.properties.properties import ready_properties
from kitrobot.verifier.properties.verdicts import check_properties
from tests.sim.building import transport
from tests.verifier.test_custom_properties import AT_A, LOADED
from tests.verifier.test_teams import team

pytestmark = pytest.mark.thorough("test_equality.py holds the plain engine; sim/test_numba.py that Numba is used")


@pytest.fixture(scope="module")
def compiled() -> Engine:
    pytest.importorskip("numba")
    return engine.make()


@pytest.mark.timeout(900)
@pytest.mark.parametrize(
    ("carriers", "timing", "failures"),
    [(1, Timing.FREE, 0), (1, Timing.FREE, 1), (2, Timing.PROMPT, 0), (2, Timing.LOCKSTEP, 0), (1, Timing.LOCKSTEP, 1)],
)
def test_compiled_and_plain_give_the_same_numbers(
    compiled: Engine, carriers: int, timing: Timing, failures: int
) -> None:
    run = transport(stock=1, carriers=carriers)
    asked = [
        AskedProperty("n", Form.NEVER, LOADED),
        AskedProperty("a", Form.AFTER, LOADED, "any loader (StockA.GreaterThan(3))"),
        AskedProperty("e", Form.EVENTUALLY, "any store-manager-B (Goal.EqualTo(1))"),
        AskedProperty("s", Form.STAYS, LOADED, AT_A),
    ]
    parts = abstract_run(run, property_variables(run, asked))

    def made(engine: Engine) -> StateSpace:
        return explore(Model(run, parts, failures, timing, KINDS), Budget(30_000), True, engine)

    plain, fast = made(PLAIN), made(compiled)
    assert [plain.state(n) for n in range(len(plain))] == [fast.state(n) for n in range(len(fast))]
    edges = int(plain.graph.first_edge[plain.expanded])
    assert list(plain.graph.targets[:edges]) == list(fast.graph.targets[:edges])
    assert list(plain.graph.taken[:edges]) == list(fast.graph.taken[:edges])
    verdicts = []
    for each in (PLAIN, compiled):
        model = Model(run, parts, failures, timing, KINDS)
        own, left_out = build_custom_properties(model, asked)
        assert left_out == []
        judged = check_properties(model, [*ready_properties(model), *own], Budget(30_000), each)
        verdicts.append([(one.answer, one.counterexample) for one in judged.verdicts])
    assert verdicts[0] == verdicts[1]


@pytest.mark.timeout(900)
@pytest.mark.parametrize("timing", list(Timing))
def test_compiled_workers_beside_each_other_find_what_one_plain_one_does(compiled: Engine, timing: Timing) -> None:
    run = transport(stock=1, carriers=2)
    parts = abstract_run(run)
    alone = explore(Model(run, parts, 0, timing), Budget(60_000), True, PLAIN)
    together = explore(Model(run, parts, 0, timing), Budget(60_000, cores=3, alone=0), True, compiled)
    assert together.batches is not None
    count, edges = len(alone), int(alone.graph.first_edge[alone.expanded])
    assert (count, alone.expanded, alone.depth) == (len(together), together.expanded, together.depth)
    assert [alone.state(n) for n in range(count)] == [together.state(n) for n in range(count)]
    assert list(alone.graph.targets[:edges]) == list(together.graph.targets[:edges])


@pytest.mark.timeout(900)
@pytest.mark.parametrize("timing", list(Timing))
def test_an_approximate_search_reaches_the_same_states_compiled(compiled: Engine, timing: Timing) -> None:
    run = transport(stock=1, carriers=2)
    parts = abstract_run(run)
    found = {}
    for cores, one in ((1, PLAIN), (3, compiled)):
        seen: list[tuple[int, ...]] = []

        def judge(space: ApproximateSpace, first: int, end: int, seen: list[tuple[int, ...]] = seen) -> None:
            seen.extend(space.state(number) for number in range(first, end))
            assert space.way(end - 1)[-1] == space.state(end - 1)

        made = explore_approximately(Model(run, parts, 0, timing), Budget(60_000, cores=cores), judge, engine=one)
        # Which of two steps to a new state comes first, and with it the numbers of its parts, may differ.
        found[cores] = len(set(seen)), len(made), made.depth
    assert found[1] == found[3]


@pytest.mark.timeout(900)
@pytest.mark.parametrize("timing", list(Timing))
def test_a_team_has_the_same_numbers_too(compiled: Engine, timing: Timing) -> None:
    run = team("2*( SeqOfPar scout ( Arm.Do(1); Arm.Do(2); ); ); ParOfSeq scout ( Boxes.Take(); Boxes.Done(); );").run
    plain, fast = (explore(Model(run, abstract_run(run), 0, timing), Budget(), True, one) for one in (PLAIN, compiled))
    assert [plain.state(n) for n in range(len(plain))] == [fast.state(n) for n in range(len(fast))]
    assert plain.complete
    assert fast.complete
