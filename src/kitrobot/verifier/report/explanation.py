"""Why a property broke: a run without events that are not needed, the moment that decided it, and how to avoid it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from kitrobot.verifier.exploration.budget import Budget
from kitrobot.verifier.model.model import Model
from kitrobot.verifier.properties.properties import Property
from kitrobot.verifier.properties.verdicts import Counterexample
from kitrobot.verifier.report.avoidance import Avoidance, find_avoidance, follow_run
from kitrobot.verifier.report.minimization import RunSearch, events_of, is_fault, minimize_run
from kitrobot.verifier.report.property_graph import Node, PropertyGraph, Successors
from kitrobot.verifier.report.property_memory import PropertyMemory

MOST_NODES = 20_000
"""States that are looked at behind one state."""


@dataclass(frozen=True)
class Explanation:
    """Why a property broke.

    Attributes:
        run: the run that breaks it, without events that are not needed.
        left_out: how many events of the run that was found are not in it.
        avoidance: how it could have been avoided.
        has_fewer_failures: whether failures are among what is left out.
    """

    run: Counterexample
    left_out: int
    avoidance: Avoidance
    has_fewer_failures: bool = False


def explain_run(
    model: Model, one: Property, run: Counterexample, states: int | None, budget: Budget
) -> Explanation | None:
    """Explains a run of a model that breaks a property; None where the first state does.

    Args:
        model: the model; it is explored anew, so no state space of it may be used afterwards.
        one: the property.
        run: the run that was found.
        states: how many states the model has; None where that is not known.
        budget: the limits: its seconds, and whether to stop; `states` is how many are looked at behind one state.
    """
    return _Explainer(model, one, states, budget).explain(run)


class _Explainer:
    def __init__(self, model: Model, one: Property, states: int | None, budget: Budget) -> None:
        self._one = one
        self._most = MOST_NODES if budget.states is None else budget.states
        self._fits = states is not None and states <= self._most
        self._successors = Successors(model, budget.interruption(budget.clock()))
        self._memory = PropertyMemory(model, one)
        self._model = model
        self._parts: list[list[int]] = []
        self._graph: PropertyGraph | None = None

    def explain(self, run: Counterexample) -> Explanation | None:
        begin = self._memory.first(run.states[0])
        if begin is None:
            return None
        is_lost = self._loss(run, (run.states[0], begin))
        search = RunSearch(self._successors, self._memory, (run.states[0], begin), is_lost)
        smaller = self._minimal(run, search)
        avoidance = find_avoidance(
            self._successors, self._memory, self._one, smaller, self._most, from_start=self._fits
        )
        events, fewer = events_of(run.steps), events_of(smaller.steps)
        has_fewer_failures = sum(map(is_fault, fewer)) < sum(map(is_fault, events))
        return Explanation(smaller, max(0, len(events) - len(fewer)), avoidance, has_fewer_failures)

    def _loss(self, run: Counterexample, first: Node) -> Callable[[Node], bool]:
        """Which nodes break the property though no step does: those of a standstill, or of a wait in vain."""
        if run.repeats_from < 0:
            return lambda node: False
        lost = set(follow_run(self._memory, run)[run.repeats_from :])
        if self._fits:
            graph = self._graph = PropertyGraph(self._successors, self._memory, first, self._most)
            lost.update(graph.nodes[number] for number in graph.standstills(self._one))
            for wait in range(self._memory.waits):
                counts = [number for number in range(graph.expanded) if graph.nodes[number][1][1 + wait]]
                self._parts += graph.fair_parts(counts)
            lost.update(graph.nodes[number] for part in self._parts for number in part)
        return lost.__contains__

    def _minimal(self, run: Counterexample, search: RunSearch) -> Counterexample:
        """The smallest run that was found: with as few failures as possible, then as few events."""
        stem, loop = run, Counterexample(run.states[-1:], ())
        if run.repeats_from >= 0:
            stem = Counterexample(run.states[: run.repeats_from + 1], run.steps[: run.repeats_from])
            loop = Counterexample(run.states[run.repeats_from :], run.steps[run.repeats_from :])
        used = min(sum(map(is_fault, events_of(run.steps))), self._model.failures)
        found = (search.find_with_failures(failures, self._most) for failures in range(used + 1))
        shortest = next((one for one in found if one is not None), stem) if self._fits else stem
        if _size(shortest) < _size(stem):
            stem = shortest
        smaller = minimize_run(stem, search)
        nodes = follow_run(self._memory, smaller)
        if len(nodes) < len(smaller.states):
            return smaller
        return self._with_loop(smaller, nodes[-1], loop)

    def _with_loop(self, stem: Counterexample, last: Node, loop: Counterexample) -> Counterexample:
        """A run with the part that repeats from its last state on."""
        begin = len(stem.steps)
        graph, number = self._graph, -1 if self._graph is None else self._graph.numbers.get(last, -1)
        part = next((one for one in self._parts if number in one), None)
        if graph is not None and part is not None:
            around = [graph.nodes[one][0] for one in graph.fair_loop(part, number)]
            loop = self._successors.run_through(around)
        elif loop.steps:
            at = loop.states.index(stem.states[-1])
            steps = (*loop.steps[at:], *loop.steps[:at])
            loop = Counterexample((stem.states[-1], *(step.state for step in steps)), steps)
        return Counterexample((*stem.states, *loop.states[1:]), (*stem.steps, *loop.steps), begin)


def _size(run: Counterexample) -> tuple[int, int]:
    """How large a run is: its failures, then its events."""
    events = events_of(run.steps)
    return sum(map(is_fault, events)), len(events)
