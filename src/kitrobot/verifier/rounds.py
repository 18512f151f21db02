"""States for which a condition holds, and rounds in which a fair run can wait for ever."""

from __future__ import annotations

from typing import Any

from kitrobot.verifier import columns as v
from kitrobot.verifier import fairness as f
from kitrobot.verifier.events import TooManyError
from kitrobot.verifier.exploring import Explored
from kitrobot.verifier.properties import Condition, Fact, OfAgent, OfShared, Stands

_STEPS = 500_000
"""Steps of a search until it is asked whether to break off; a quarter of a second, or some seconds of CPython."""
_CHUNK = 100_000


def holds_somewhere(made: Explored, condition: Condition) -> bool:
    """Whether a condition holds in a state that was reached."""
    return sum(_mark(made, condition)[1]) > 0


def first_marked(made: Explored, condition: Condition) -> int:
    """The first state that nothing leaves and for which a condition holds; -1 for none."""
    marks, _ = _mark(made, condition)
    dead = made.graph.dead[: int(made.model.t.regs[v.DEAD])]
    return next((int(number) for number in dead if marks[int(number)]), -1)


def _mark(made: Explored, condition: Condition) -> tuple[Any, list[int]]:
    """A mark for each state for which a condition holds, and how many there are in each part of the states."""
    facts: list[int] = []
    truths: list[int] = []
    for clause, all_of in enumerate(condition):
        for fact in all_of:
            field, truth = _truth(made, fact)
            facts += [clause, field, len(truths)]
            truths += truth
    engine = made.engine
    marks = engine.bytes(max(1, len(made)))
    rows, table, two = engine.row(facts), engine.row(truths), made.model.layout.words == 2
    counts = []
    for first in range(0, len(made), _CHUNK):
        end = min(first + _CHUNK, len(made))
        counts.append(int(engine.mark(made.model.t, made.graph, first, end, two, rows, table, marks)))
    return marks, counts


def _truth(made: Explored, fact: Fact) -> tuple[int, list[int]]:
    """The field that a fact is about, and whether it is true, by the field's number."""
    model = made.model
    if isinstance(fact, OfShared):
        return 0, [int(fact.test(one)) for one in model.shareds()]
    if isinstance(fact, OfAgent):
        return 1 + fact.agent, [int(fact.test(one)) for one in model.insides(fact.agent)]
    assert isinstance(fact, Stands)
    fixed, road = model.t.fixed, model.roads.of[fact.agent]
    width = int(fixed[v.CONF_WIDTH])
    docks = [dock for dock in fact.docks if model.roads.of_dock[dock] == road]
    truth = []
    for number in range(int(model.t.regs[v.CONFS])):
        row = number * width + v.C_STAND
        truth.append(int(any(int(model.t.confs[row + dock]) >> fact.agent & 1 for dock in docks)))
    return int(fixed[v.ROAD_FIELD]) + road, truth


def fair_round(made: Explored, waits: Condition, from_start: bool) -> tuple[list[int], bool]:
    """The states of a round in which a fair run waits for ever: where it begins, and those that follow, up to there
    again; whether all was looked through.
    """
    if not len(made):
        return [], False
    marks, counts = _mark(made, waits)
    engine, graph = made.engine, made.graph
    found = engine.zeros(len(made) + 1)
    if from_start:
        count = int(engine.reach(graph, marks, made.expanded, found))
        wanted = 2
    else:
        count, wanted = 0, 1
        if sum(counts):
            for number in range(len(made)):
                if marks[number]:
                    found[count] = number
                    count += 1
    if count == 0:
        return [], True
    search = _search(made, marks, wanted, found, count)
    code = f.BUSY
    while True:
        code = engine.search(made.model.t, made.graph, search, _STEPS)
        if code == f.FAIR:
            break
        if code == f.MISSING:
            try:
                made.fill(int(made.model.t.regs[v.CODE]))
            except TooManyError:
                return [], False
            continue
        if code == f.DONE:
            search = f.next_round(search)
            if search.numbers[f.ROOTS] == 0:
                return [], True
        if made.breaks_off():
            return [], False
    first, top = int(search.numbers[f.FIRST]), int(search.numbers[f.TOP])
    return _round(made, search.stack[first:top], search), True


def _search(made: Explored, marks: Any, wanted: int, found: Any, count: int) -> f.Search:
    engine, size = made.engine, len(made) + 1
    colour = engine.zeros(size)
    for n in range(count):
        colour[found[n]] = 1
    numbers = [0] * f.SEARCH_NUMBERS
    numbers[f.ROOTS], numbers[f.COLOUR], numbers[f.EXPANDED] = count, 1, made.expanded
    numbers[f.TWO] = int(made.model.layout.words == 2)
    rows = [engine.zeros(size) for _ in range(6)]
    return f.Search(
        engine.row(numbers), colour, rows[0], rows[1], found, rows[2], rows[3], rows[4], rows[5], engine.row([0] * 8)
    )


def _round(made: Explored, part: Any, search: f.Search) -> list[int]:
    """A way through a strongly connected part and back that takes every class that is taken in it; the state where it
    begins alone for one state.
    """
    engine, graph = made.engine, made.graph
    begin = int(min(part))
    marks = engine.bytes(len(made))
    for state in part:
        marks[state] = 1
    table = made.model.t.taken
    steps = engine.zeros(2 * max(1, int(made.model.t.regs[v.TAKEN])))
    for n in range(len(steps)):
        steps[n] = -1
    engine.sample(graph, part, marks, steps)
    sets = []
    for n in range(len(steps) // 2):
        if steps[2 * n] >= 0:
            row = [int(one) for one in table[n * v.TAKEN_WIDTH : (n + 1) * v.TAKEN_WIDTH]]
            sets.append(
                (sum(one << k * v.MOST_AGENTS for k, one in enumerate(row)), int(steps[2 * n]), int(steps[2 * n + 1]))
            )
    covered, found, at = 0, [begin], begin
    before, queue = search.low, search.order
    for taken, state, target in sorted(sets, key=lambda one: -one[0].bit_count()):
        if taken & ~covered == 0:
            continue
        if at != state:
            found += _way(made, at, state, marks, before, queue)
        found.append(target)
        at, covered = target, covered | taken
    return found if at == begin else [*found, *_way(made, at, begin, marks, before, queue)]


def _way(made: Explored, start: int, end: int, marks: Any, before: Any, queue: Any) -> list[int]:
    """The states of a shortest way, without the start."""
    made.engine.way(made.graph, start, end, marks, before, queue)
    found = [end]
    while int(before[found[-1]]) != start:
        found.append(int(before[found[-1]]))
    return found[::-1]
