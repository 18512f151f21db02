"""Verdicts of an approximate search: what is broken by an event, a state or a step is seen before it is forgotten.

Not here: what can only be seen in steps that are kept (waiting in vain), or in what came before a state (histories).
Such a property is *not decided*. A standstill is looked for around calm states: around all that no step leaves, and a
sample of the others, since each takes as long as a hundred steps of the search.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from kitrobot.verifier.exploration.approximate_search import ApproximateSpace, explore_approximately
from kitrobot.verifier.exploration.batch_search import BatchSearch
from kitrobot.verifier.exploration.budget import Budget, CutReason
from kitrobot.verifier.exploration.engines import Engine
from kitrobot.verifier.model.model import Model
from kitrobot.verifier.properties.fair_cycles import mark_keys
from kitrobot.verifier.properties.properties import Condition, Property
from kitrobot.verifier.properties.standstill import StandstillSearch
from kitrobot.verifier.properties.verdicts import (
    Answer,
    CheckResult,
    Counterexample,
    Verdict,
    counterexample_through,
)
from kitrobot.verifier.tables import columns as v

_SAMPLE, _ONE_IN = 20_000, 500
"""States that are looked at in search of standstills: so many, and one more for so many states that were reached."""


def is_judged_approximately(one: Property) -> bool:
    """Whether an approximate search can find that a property is broken."""
    return one.waits is None and one.history is None


def check_approximately(
    model: Model, properties: Sequence[Property], budget: Budget, engine: Engine | None = None
) -> CheckResult:
    """Explores a model that has not been explored approximately, and says which properties it found broken."""
    judge = _Judge([one for one in properties if is_judged_approximately(one)])
    stepwise = judge.look_at_steps if any(one.breaks is not None for one in judge.open) else None
    is_asked = bool(judge.open)
    has_ended = budget.stop
    budget = replace(budget, stop=lambda: not judge.open or has_ended())
    space = explore_approximately(model, budget, judge.look_at_states, stepwise, engine)
    cut = space.cut if judge.open else None
    return CheckResult(
        model.timing,
        model.failures,
        tuple(judge.verdict(one) for one in properties),
        states=len(space),
        depth=space.depth,
        complete=False,
        seconds=space.seconds,
        memory=space.memory,
        cut=cut,
        is_approximate=True,
        odds=space.odds if is_asked else None,
    )


class _Judge:
    """What was found broken so far.

    Attributes:
        open: the properties that nothing was found to break.
        found: for others, by name, the run that breaks each.
    """

    def __init__(self, properties: list[Property]) -> None:
        self.open = properties
        self.found: dict[str, Counterexample] = {}
        self._standstills = StandstillSearch()

    def verdict(self, one: Property) -> Verdict:
        """What is known of a property."""
        if one.name in self.found:
            return Verdict(one, Answer.BROKEN, self.found[one.name])
        return Verdict(one, Answer.NOTHING_FOUND if is_judged_approximately(one) else Answer.NOT_DECIDED)

    def look_at_states(self, space: ApproximateSpace, first: int, end: int) -> None:
        """Looks at the states from one number on to before another, and at what happened first since."""
        for one in list(self.open):
            run = (
                self._event_run(space, one)
                or self._state_run(space, one, first, end)
                or self._standstill_run(space, one, end)
            )
            self._note(one, run)

    def look_at_steps(self, space: ApproximateSpace, batches: BatchSearch) -> None:
        """Looks at the steps of a batch."""
        for one in list(self.open):
            if one.breaks is not None:
                self._note(one, self._step_run(space, batches, one.breaks))

    def _note(self, one: Property, run: Counterexample | None) -> None:
        if run is not None:
            self.found[one.name] = run
            self.open.remove(one)

    def _event_run(self, space: ApproximateSpace, one: Property) -> Counterexample | None:
        first = space.first_occurrences()
        kinds = [what for what in one.broken_by if what in first]
        if not kinds:
            return None
        kind = min(kinds, key=lambda what: (first[what], what))
        way = space.way(first[kind])
        last = next(n for n, (_, _, came) in enumerate(space.steps_from(way[-1])) if came >> kind & 1)
        return counterexample_through(space, way, last)

    def _state_run(self, space: ApproximateSpace, one: Property, first: int, end: int) -> Counterexample | None:
        if one.never is None:
            return None
        base = space.base
        marks, counts = mark_keys(space, space.graph, first - base, end - base, one.never)
        if not sum(counts):
            return None
        return counterexample_through(space, space.way(_next_mark(marks, first - base) + base))

    def _step_run(
        self, space: ApproximateSpace, batches: BatchSearch, breaks: tuple[Condition, Condition]
    ) -> Counterexample | None:
        batch, base = batches.batch, space.base
        keys = space.graph._replace(x=batch.x, y=batch.y)
        batch_first = int(space.model.t.regs[v.BATCH_FIRST])
        for first, end, begin, until in batches.steps():
            was, counts = mark_keys(space, space.graph, first - base, end - base, breaks[0])
            if not sum(counts):
                continue
            now, counts = mark_keys(space, keys, begin, until, breaks[1])
            if not sum(counts):
                continue
            for state in range(first, end):
                if was[state - base]:
                    at = int(batch.begins[state - batch_first])
                    if any(now[at : int(batch.ends[state - batch_first])]):
                        return counterexample_through(space, space.way(state), _next_mark(now, at) - at)
        return None

    def _standstill_run(self, space: ApproximateSpace, one: Property, end: int) -> Counterexample | None:
        """Looks around calm states among those whose steps are known; `calm` has them since the last look."""
        if one.is_wrong is None:
            return None
        calm = [int(number) for number in space.graph.calm[: int(space.model.t.regs[v.CALMS])]]
        dead = {-number - 1: None for number in calm if number < 0}
        others = [number for number in calm if number >= 0]
        room = _SAMPLE + end // _ONE_IN
        # Most states are left at once, by the second state that is looked at.
        each = max(1, -(-2 * len(others) // max(1, room - self._standstills.looked)))
        base = space.base
        marks, counts = mark_keys(space, space.graph, 0, len(space) - base, one.is_wrong)
        if not sum(counts):
            return None
        for number in [*dead, *others[::each]]:
            if marks[number - base] and (number in dead or self._standstills.looked < room):
                around = self._standstills.find_way(space, space.state(number), one.is_wrong)
                if around:
                    return counterexample_through(space, [*space.way(number), *around[1:]], repeats=True)
            if space.interruption() in (CutReason.TIME, CutReason.STOPPED):
                return None
        return None


def _next_mark(marks: Sequence[int], first: int) -> int:
    """The place of the first mark from a place on."""
    at = first
    while not marks[at]:
        at += 1
    return at
