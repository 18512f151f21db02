"""The last moment at which a property could still be kept, along a run that breaks it, and another way from there.

A state *can keep* the property if a fair run without further failures goes on from it and never breaks it. For a wait
in vain such a run has what is waited for, again and again. What is beyond the limits of a search is unknown, and then
the answer says so.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from enum import Enum

from kitrobot.verifier.properties.properties import Property
from kitrobot.verifier.properties.verdicts import Counterexample, Step
from kitrobot.verifier.report.keeping_walk import find_keeping_walk
from kitrobot.verifier.report.property_graph import FAULTS, Node, PropertyGraph, Successor, Successors
from kitrobot.verifier.report.property_memory import PropertyMemory
from kitrobot.verifier.tables.events import Event, EventKind

_PART = 10
"""Of a large mission so small a part of the nodes is looked at first."""
_NEAR = 500
"""Nodes that are looked at behind the end of a walk."""


class Certainty(Enum):
    """What is known of the last moment."""

    LAST = "last"
    """From the next state on every run breaks the property."""
    ALWAYS = "always"
    """It is never too late: the property could still be kept in the part that repeats."""
    NEVER = "never"
    """Every run breaks it, from the first state on."""
    UNKNOWN = "unknown"
    """The search ended before that."""


@dataclass(frozen=True)
class Avoidance:
    """How a run that breaks a property could have been avoided.

    Attributes:
        certainty: what is known of the moment.
        step: the step of the run that decided it, from 0; -1 if there is none, or none is known.
        other: the run that keeps the property: the same up to that step, then another way, up to where it may go on
            for ever. None without such a step.
        ends_well: whether `other` comes to where every goal is reached, or every program has ended.
    """

    certainty: Certainty
    step: int = -1
    other: Counterexample | None = None
    ends_well: bool = False


def follow_run(memory: PropertyMemory, run: Counterexample) -> list[Node]:
    """The states of a run with the memory of the property in each, up to the step that breaks it."""
    found: list[Node] = []
    now = memory.first(run.states[0])
    for number, state in enumerate(run.states):
        if number:
            assert now is not None, "the last step did not break it"
            kinds = sum(1 << kind for kind in {event.what for event in run.steps[number - 1].events})
            now = memory.after(now, run.states[number - 1], kinds, state)
        if now is None:
            return found
        found.append((state, now))
    return found


def find_avoidance(
    successors: Successors, memory: PropertyMemory, one: Property, run: Counterexample, most: int, from_start: bool
) -> Avoidance:
    """Finds the last moment of a run at which the property could still be kept.

    Args:
        successors: the steps of the model.
        memory: the property, followed along runs.
        one: the property.
        run: the run that breaks it.
        most: the most nodes that are looked at from one state on.
        from_start: whether all nodes are worth looking at first; else only those behind ever earlier states.
    """
    nodes = follow_run(memory, run)
    if from_start:
        return _search(successors, memory, one, run, nodes, most, from_start)
    # Of a large mission a little is looked at first: a walk often shows more in less time.
    found = _search(successors, memory, one, run, nodes, most // _PART, from_start)
    if found.certainty is Certainty.UNKNOWN and found.other is None:
        return _search(successors, memory, one, run, nodes, most, from_start)
    return found


def _search(
    successors: Successors,
    memory: PropertyMemory,
    one: Property,
    run: Counterexample,
    nodes: Sequence[Node],
    most: int,
    from_start: bool,
) -> Avoidance:
    """The same, of the nodes of the run."""
    doomed = len(nodes)
    for start in _starts(len(nodes), from_start):
        graph = PropertyGraph(successors, memory, nodes[start], most)
        keeping = KeepingNodes(graph, one, memory.waits)
        numbers = [graph.numbers.get(node, -1) for node in nodes[start:doomed]]
        able = [at for at, number in enumerate(numbers) if number in keeping.able]
        if able:
            is_certain = all(number in keeping.lost for number in numbers[able[-1] + 1 :])
            at, certainty = able[-1], Certainty.LAST if is_certain else Certainty.UNKNOWN
            if 0 <= run.repeats_from <= start + at:
                certainty = Certainty.ALWAYS
                at = min(
                    (one for one in able if start + one >= run.repeats_from),
                    key=lambda one: keeping.able[numbers[one]],
                )
            return _avoided(keeping, numbers[at], run, start + at, certainty)
        if not all(number in keeping.lost for number in numbers):
            return _walked(successors, memory, one, run, nodes[:doomed])
        doomed = start
    return Avoidance(Certainty.NEVER)


def _walked(
    successors: Successors, memory: PropertyMemory, one: Property, run: Counterexample, nodes: Sequence[Node]
) -> Avoidance:
    """What walks from ever earlier nodes show; from what is behind these nodes the property cannot be kept."""

    def can_stay(node: Node) -> bool:
        return 0 in KeepingNodes(PropertyGraph(successors, memory, node, _NEAR), one, memory.waits).able

    for at in _starts(len(nodes), from_start=False):
        walk = find_keeping_walk(successors, memory, nodes[at], can_stay)
        if walk is not None:
            states = (*run.states[: at + 1], *(step.state for step in walk.steps))
            other = Counterexample(states, (*run.steps[:at], *walk.steps))
            certainty = Certainty.LAST if at == len(nodes) - 1 else Certainty.UNKNOWN
            if 0 <= run.repeats_from <= at:
                certainty = Certainty.ALWAYS
            return Avoidance(certainty, at, other, walk.ends_well)
    return Avoidance(Certainty.UNKNOWN)


def _starts(count: int, from_start: bool) -> Iterator[int]:
    """The first place alone, or places from the last one back, in ever larger strides."""
    back = 1
    while back < count and not from_start:
        yield count - back
        back *= 2
    if count:
        yield 0


class KeepingNodes:
    """Which nodes of a graph can keep the property.

    Attributes:
        graph: the graph.
        able: those that can, each with how many steps it takes to where a run can stay.
        lost: those that cannot.
    """

    def __init__(self, graph: PropertyGraph, one: Property, waits: int) -> None:
        self.graph = graph
        still = graph.standstills(one)
        stays: list[int] = []
        for part in graph.fair_parts([number for number in range(graph.expanded) if number not in still], FAULTS):
            memories = [graph.nodes[number][1][1:] for number in part]
            if all(any(not memory[wait] for memory in memories) for wait in range(waits)):
                # Of one that is waited for in turn, where it has come.
                stays += [number for number, memory in zip(part, memories, strict=True) if not waits or not all(memory)]
        self._stays = stays
        if graph.is_cut:
            stays = []
        self.able = graph.distances_to(stays, FAULTS)
        unknown = graph.distances_to(range(graph.expanded, len(graph.nodes)), FAULTS)
        known = range(0 if graph.is_cut else graph.expanded)
        self.lost = {number for number in known if number not in self.able and number not in unknown}

    def way_on(self, first: int, unlike: Step) -> tuple[list[tuple[Successor, int]], bool]:
        """A way from a node that is able to where a run can stay, best where the mission has come to a good end; also
        returns whether it has.

        Of the steps that begin one, it begins with one as much like the step that was taken as possible.
        """
        graph = self.graph
        ends = graph.distances_to((number for number in self._stays if graph.has_good_end(number)), FAULTS)
        distances = ends if first in ends else self.able
        way: list[tuple[Successor, int]] = []
        steps = [
            (step, target)
            for step, target in graph.steps(first)
            if target in distances and not step.kinds & FAULTS and step.state != unlike.state
        ]
        if not steps:
            return [], False
        wanted = Counter(unlike.events)
        way.append(min(steps, key=lambda one: (_difference(graph.events(first, one[0]), wanted), distances[one[1]])))
        while distances[at := way[-1][1]]:
            way.append(
                next(
                    (step, target)
                    for step, target in graph.steps(at)
                    if distances.get(target, -1) == distances[at] - 1 and not step.kinds & FAULTS
                )
            )
        return way, distances is ends


def _difference(events: Sequence[Event], wanted: Counter[Event]) -> int:
    """How many events, except ticks, are in one but not in the other."""
    found = Counter(event for event in events if event.what is not EventKind.TICK)
    wanted = Counter({event: count for event, count in wanted.items() if event.what is not EventKind.TICK})
    return (found - wanted).total() + (wanted - found).total()


def decisive_events(run: Counterexample, avoidance: Avoidance) -> list[Event]:
    """The events of the step that decided a run, except ticks: those that the other way does not have there, or all."""
    at, other = avoidance.step, avoidance.other
    if not 0 <= at < len(run.steps):
        return []
    events = [event for event in run.steps[at].events if event.what is not EventKind.TICK]
    instead = other.steps[at].events if other is not None and at < len(other.steps) else ()
    return [event for event in events if event not in instead] or events


def _avoided(keeping: KeepingNodes, number: int, run: Counterexample, step: int, certainty: Certainty) -> Avoidance:
    """The other way from a node that is able, which is the state of a run before a step."""
    if step >= len(run.steps):
        # The last state of a run that waits there for ever.
        taken = Step((), run.states[-1])
    else:
        taken = run.steps[step]
    way, ends_well = keeping.way_on(number, taken)
    at, states, steps = number, list(run.states[: step + 1]), list(run.steps[:step])
    for one, target in way:
        steps.append(Step(keeping.graph.events(at, one), one.state))
        states.append(one.state)
        at = target
    return Avoidance(certainty, step, Counterexample(tuple(states), tuple(steps)), ends_well)
