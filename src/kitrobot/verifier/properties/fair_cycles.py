"""States in which a condition holds, and cycles in which a fair run can wait for ever."""

from __future__ import annotations

from typing import Any

from kitrobot.verifier.exploration import fairness as f
from kitrobot.verifier.exploration.budget import CutReason
from kitrobot.verifier.exploration.engines import PLAIN
from kitrobot.verifier.exploration.exploration import StateSpace
from kitrobot.verifier.properties.properties import (
    AgentFact,
    Condition,
    DockFact,
    Fact,
    Property,
    SensedCondition,
    SharedFact,
)
from kitrobot.verifier.tables import columns as v
from kitrobot.verifier.tables.events import ModelTooLargeError
from kitrobot.verifier.tables.tables import Graph

_STEPS, _PLAIN_STEPS = 500_000, 20_000
"""Steps of a search between two polls of the limits, compiled or plain: about a quarter of a second."""
CHUNK = 20_000
"""The number of states on which conditions are evaluated at once."""


def holds_somewhere(space: StateSpace, condition: Condition) -> bool:
    """Whether a condition holds in any reached state."""
    return sum(mark_states(space, condition)[1]) > 0


def find_first(space: StateSpace, condition: Condition) -> int:
    """The first state in which a condition holds; -1 for none."""
    marks, counts = mark_states(space, condition)
    first = next((CHUNK * n for n, count in enumerate(counts) if count), len(space))
    return next((number for number in range(first, len(space)) if marks[number]), -1)


def find_first_crossing(space: StateSpace, before: Condition, after: Condition) -> tuple[int, int]:
    """Finds the first step from a state in which one condition holds to a state in which another does.

    Returns the state and the place of the step among its steps; -1, -1 for none. If time is up, not all states are
    searched.
    """
    was, _ = mark_states(space, before)
    now, _ = mark_states(space, after)
    state = -1
    for at in range(0, space.expanded, CHUNK):
        if at and (cut := space.interruption()):
            space.interrupted_by = cut
            break
        state = int(space.engine.find_crossing(space.graph, at, min(at + CHUNK, space.expanded), was, now))
        if state >= 0:
            break
    if state < 0:
        return -1, -1
    first, end = int(space.graph.first_edge[state]), int(space.graph.first_edge[state + 1])
    target = next(int(one) for one in space.graph.targets[first:end] if now[one])
    wanted = space.state(target)
    return state, next(n for n, (one, _, _) in enumerate(space.steps(state)) if one == wanted)


def mark_states(space: StateSpace, condition: Condition) -> tuple[Any, list[int]]:
    """Marks each state in which a condition holds; also returns how many there are in each chunk of states."""
    return mark_keys(space, space.graph, 0, len(space), condition)


def mark_keys(space: StateSpace, graph: Graph, first: int, end: int, condition: Condition) -> tuple[Any, list[int]]:
    """The same for the keys of a graph from `first` to before `end`: a mark for each key before `end`."""
    if isinstance(condition, SensedCondition):
        return _mark_sensed(space, graph, first, end, condition)
    facts: list[int] = []
    truths: list[int] = []
    for clause, all_of in enumerate(condition):
        for fact in all_of:
            field, truth = _truth(space, fact)
            facts += [clause, field, len(truths)]
            truths += truth
    engine = space.engine
    marks = engine.bytes(max(1, end))
    rows, table, two = engine.row(facts), engine.row(truths), space.model.layout.words == 2
    counts = []
    for at in range(first, end, CHUNK):
        until = min(at + CHUNK, end)
        counts.append(int(engine.mark_states(space.model.t, graph, at, until, two, rows, table, marks)))
    return marks, counts


def _mark_sensed(
    space: StateSpace, graph: Graph, begin: int, end: int, condition: SensedCondition
) -> tuple[Any, list[int]]:
    """The same for a condition on sensed values; if time is up, the remaining states are left unmarked."""
    engine, two, model = space.engine, space.model.layout.words == 2, space.model
    marks, counts = engine.bytes(max(1, end)), []
    columns = [engine.words(CHUNK) for _ in condition.agents]
    known: dict[tuple[int, ...], bool] = {}
    for first in range(begin, end, CHUNK):
        if cut := space.interruption():
            space.interrupted_by = cut
            break
        until = min(first + CHUNK, end)
        for i, keys in zip(condition.agents, columns, strict=True):
            engine.sense_agent(model.t, graph, first, until, two, i, keys)
        count = 0
        keys_by_agent = [keys.tolist() for keys in columns]
        if condition.reads_shared:
            keys_by_agent.append(_shared_numbers(space, graph, first, until))
        rows = zip(*keys_by_agent, strict=False)
        for number, row in zip(range(first, until), rows, strict=False):
            holds = known.get(row)
            if holds is None:
                holds = known[row] = condition.test(row)
            if holds:
                marks[number] = 1
                count += 1
        counts.append(count)
    return marks, counts


def _shared_numbers(space: StateSpace, graph: Graph, first: int, end: int) -> list[int]:
    """The numbers of the shared states of a range of states."""
    layout = space.model.layout
    keys = (graph.y if layout.word[0] else graph.x)[first:end]
    return [int(key) >> layout.shift[0] & layout.mask[0] for key in keys]


def _truth(space: StateSpace, fact: Fact) -> tuple[int, list[int]]:
    """The field of a fact, and the truth of the fact for each number in that field."""
    model = space.model
    if isinstance(fact, SharedFact):
        return 0, [int(fact.test(one)) for one in model.shareds()]
    if isinstance(fact, AgentFact):
        return 1 + fact.agent, [int(fact.test(one)) for one in model.insides(fact.agent)]
    assert isinstance(fact, DockFact)
    fixed, road = model.t.fixed, model.roads.of[fact.agent]
    width, end = int(fixed[v.CONF_WIDTH]), int(fixed[v.CONF_WIDTH]) * int(model.t.regs[v.CONFS])
    stand = [0] * int(model.t.regs[v.CONFS])
    for dock in fact.docks:
        if model.roads.of_dock[dock] == road:
            column = model.t.confs[v.C_STAND + dock : end : width]
            stand = [was | int(one) for was, one in zip(stand, column, strict=True)]
    return int(fixed[v.ROAD_FIELD]) + road, [one >> fact.agent & 1 for one in stand]


def find_fair_cycle(space: StateSpace, one: Property) -> tuple[list[int], list[int]]:
    """Finds a fair run that waits for ever, for a property of liveness.

    Returns two lists of states: the path from where waiting counts to the start of the cycle, and the cycle from its
    start back to it. Both are empty if there is none, or if the search ended early (`StateSpace.interrupted_by`).
    """
    assert one.waits is not None
    space.interrupted_by = space.interrupted_by or space.interruption()
    if not len(space) or space.interrupted_by:
        return [], []
    marks, counts = mark_states(space, one.waits)
    engine = space.engine
    steps = _PLAIN_STEPS if engine is PLAIN else _STEPS
    size = len(space) + 1
    colour, found, before = engine.zeros(size), engine.zeros(size), engine.zeros(size)
    reached = engine.row([0, (1 if one.from_start else len(space)) if sum(counts) else 0, 0, 0, space.expanded])
    since = marks if one.since is None else mark_states(space, one.since)[0]
    while not engine.mark_reachable(space.graph, marks, since, colour, found, before, reached, steps):
        if cut := space.interruption():
            space.interrupted_by = cut
            return [], []
    if not reached[f.REACHED]:
        return [], []
    search = component_search(space, colour, found, int(reached[f.REACHED]))
    search, is_found = next_fair_component(space, search, steps)
    if not is_found:
        return [], []
    first, top = int(search.numbers[f.FIRST]), int(search.numbers[f.TOP])
    part = search.stack[first:top]
    around = cover_component(space, part, int(min(part)), search.low, search.order)
    lead = [around[0]]
    while int(before[lead[-1]]) >= 0:
        lead.append(int(before[lead[-1]]))
    return lead[::-1], around


def next_fair_component(
    space: StateSpace, search: f.ComponentSearch, steps: int = _PLAIN_STEPS
) -> tuple[f.ComponentSearch, bool]:
    """Goes on until a fair component is on top of the stack; also returns whether there is one.

    There is none at the end, and where the search ended early (`StateSpace.interrupted_by`).
    """
    while True:
        code = space.engine.find_fair_component(space.model.t, space.graph, search, steps)
        if code == f.FAIR:
            return search, True
        if code == f.MISSING:
            try:
                space.fill(int(space.model.t.regs[v.CODE]))
            except ModelTooLargeError:
                space.interrupted_by = CutReason.SIZE
                return search, False
            continue
        if code == f.DONE:
            search = f.next_round(search)
            if search.numbers[f.ROOTS] == 0:
                return search, False
        if cut := space.interruption():
            space.interrupted_by = cut
            return search, False


def component_search(space: StateSpace, colour: Any, found: Any, count: int) -> f.ComponentSearch:
    """A search through so many states, which are in `found` and whose `colour` is 1; see `fairness`."""
    engine, size = space.engine, len(space) + 1
    numbers = [0] * f.SEARCH_NUMBERS
    numbers[f.ROOTS], numbers[f.COLOUR], numbers[f.EXPANDED] = count, 1, space.expanded
    numbers[f.TWO] = int(space.model.layout.words == 2)
    rows = [engine.zeros(size) for _ in range(6)]
    return f.ComponentSearch(
        *(engine.row(numbers), colour, rows[0], rows[1], found, *rows[2:]),
        *(engine.row([0] * v.TAKEN_WIDTH) for _ in range(4)),
    )


def cover_component(space: StateSpace, part: Any, begin: int, before: Any, queue: Any) -> list[int]:
    """A way from a state through a strongly connected part and back that takes every class that is taken in it; the
    state alone for one state. `before` and `queue` are written: a number for each state of the space.
    """
    engine, graph = space.engine, space.graph
    marks = engine.bytes(len(space) + 1)
    for state in part:
        marks[state] = 1
    table = space.model.t.taken
    steps = engine.zeros(2 * max(1, int(space.model.t.regs[v.TAKEN])))
    for n in range(len(steps)):
        steps[n] = -1
    engine.sample_steps(graph, part, marks, steps)
    sets = []
    for n in range(len(steps) // 2):
        if steps[2 * n] >= 0:
            row = [int(one) for one in table[n * v.TAKEN_WIDTH : (n + 1) * v.TAKEN_WIDTH]]
            sets.append(
                (sum(one << k * v.MOST_AGENTS for k, one in enumerate(row)), int(steps[2 * n]), int(steps[2 * n + 1]))
            )
    covered, found, at = 0, [begin], begin
    for taken, state, target in sorted(sets, key=lambda one: -one[0].bit_count()):
        if taken & ~covered == 0:
            continue
        if at != state:
            found += _shortest_path(space, at, state, marks, before, queue)
        found.append(target)
        at, covered = target, covered | taken
    return found if at == begin else [*found, *_shortest_path(space, at, begin, marks, before, queue)]


def _shortest_path(space: StateSpace, start: int, end: int, marks: Any, before: Any, queue: Any) -> list[int]:
    """The states of a shortest path, without the start."""
    space.engine.find_shortest_path(space.graph, start, end, marks, before, queue)
    found = [end]
    while int(before[found[-1]]) != start:
        found.append(int(before[found[-1]]))
    return found[::-1]
