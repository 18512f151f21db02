"""Verdicts: the states of a model under one assumption are explored, and every property is judged by them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from enum import Enum
from itertools import pairwise
from operator import itemgetter

from tests.verifier.reference.events import EventKind
from tests.verifier.reference.exploration import Budget, StateSpace, explore
from tests.verifier.reference.fairness import fair_part, reachable, targets, way
from tests.verifier.reference.model import Model, State
from tests.verifier.reference.motion import Move
from tests.verifier.reference.properties import Property
from tests.verifier.reference.timing import Clock, Step, Timing


class Answer(Enum):
    """What came of checking one property."""

    HOLDS = "holds"
    BROKEN = "broken"
    NOT_FINISHED = "not finished"
    VACUOUS = "vacuous"


@dataclass(frozen=True)
class Counterexample:
    """A run of the model: the states in order, the steps between them, and the state from which on it repeats (-1: it
    does not).
    """

    states: tuple[State, ...]
    steps: tuple[Step, ...]
    repeats_from: int = -1


@dataclass(frozen=True)
class Verdict:
    """What came of one property under one assumption.

    Attributes:
        property: the property.
        answer: never HOLDS when the search was cut short.
        way: how it is broken; None unless it is.
    """

    property: Property
    answer: Answer
    way: Counterexample | None = None


@dataclass(frozen=True)
class CheckResult:
    """The verdicts under one assumption.

    Attributes:
        timing, failures: the assumption.
        verdicts: one for each property.
        states: how many states were reached.
        depth: steps to the one furthest away.
        complete: whether there are no more.
        seconds: how long exploring took.
    """

    timing: Timing
    failures: int
    verdicts: tuple[Verdict, ...]
    states: int
    depth: int
    complete: bool
    seconds: float


def check_properties(
    model: Model, properties: Sequence[Property], timing: Timing, failures: int, budget: Budget
) -> CheckResult:
    """Explores a model and judges properties by it."""
    clock = Clock(model, timing)
    first: dict[Move | EventKind, tuple[int, Step]] = {}
    concerned: set[str] = {one.name for one in properties if not one.about and one.concerned is None}
    by_state = [one for one in properties if one.concerned is not None]

    def looking(number: int, state: State, step: Step | None, after: State) -> bool:
        if step is None:
            for one in by_state:
                if one.name not in concerned and one.concerned is not None and one.concerned(state):
                    concerned.add(one.name)
            return True
        for event in step.events:
            if event.what not in first:
                first[event.what] = number, step
        return True

    made = explore(clock, budget, looking, keeps_steps=True)
    concerned.update(one.name for one in properties if not one.about.isdisjoint(first))
    verdicts = []
    for one in properties:
        found = min((first[what] for what in one.broken_by if what in first), key=itemgetter(0), default=None)
        if found is not None:
            verdicts.append(Verdict(one, Answer.BROKEN, _way_to(clock, made, made.path(found[0]), found[1])))
            continue
        path = _endless(clock, made, one)
        if path is not None:
            verdicts.append(Verdict(one, Answer.BROKEN, path))
        elif not made.complete:
            verdicts.append(Verdict(one, Answer.NOT_FINISHED))
        else:
            verdicts.append(Verdict(one, Answer.HOLDS if one.name in concerned else Answer.VACUOUS))
    return CheckResult(timing, failures, tuple(verdicts), len(made.states), made.depth, made.complete, made.seconds)


def _endless(clock: Clock, made: StateSpace, one: Property) -> Counterexample | None:
    """A run that breaks a property by standing still or by waiting for ever."""
    expanded = len(made.first_edge) - 1
    if one.is_wrong is not None:
        for number in range(expanded):
            if one.is_wrong(made.states[number]) and all(to == number for to in targets(made, number)):
                return _way_to(clock, made, made.path(number), None, repeats=True)
        number = _standstill(clock, made, one.is_wrong)
        return None if number < 0 else _way_to(clock, made, made.path(number), None, repeats=True)
    if one.waits is None:
        return None
    waiting = [one.waits(state) for state in made.states]
    inside = reachable(made, waiting) if one.from_start else [n for n, waits in enumerate(waiting) if waits]
    part = fair_part(made, inside, clock.count)
    if part is None:
        return None
    begin = min(part)
    path = made.path(begin)
    return _way_to(clock, made, [*path, *_round(made, set(part), begin)], None, repeats=True, first=len(path) - 1)


def _standstill(clock: Clock, made: StateSpace, is_wrong: Callable[[State], bool]) -> int:
    """The first state from which on nothing happens but that programs go round and say nothing new; -1 for none."""
    calm = {EventKind.TICK, Move.BEGIN, Move.HALT}
    still = {
        number
        for number, state in enumerate(made.states[: len(made.first_edge) - 1])
        if is_wrong(state) and all(event.what in calm for step in clock.steps(state) for event in step.events)
    }
    while left := {number for number in still if not still.issuperset(targets(made, number))}:
        still -= left
    return next((number for number in sorted(still) if not _hears_news(clock.model, made, number)), -1)


def _hears_news(model: Model, made: StateSpace, number: int) -> bool:
    """Whether a device is told two things in turn in the states that can be reached, or anything else is new."""
    reached, waiting = {number}, [number]
    heard: dict[tuple[int, int], object] = {}
    while waiting:
        one = waiting.pop()
        for i in range(model.count):
            said = model.said(made.states[one], i)
            if said is None:
                return True
            for (actuator, command, first), second in said:
                if heard.setdefault((i, actuator), (command, first, second)) != (command, first, second):
                    return True
        new = set(targets(made, one)) - reached
        reached |= new
        waiting += new
    return False


def _round(made: StateSpace, part: set[int], begin: int) -> list[int]:
    """A way through a strongly connected part and back that takes every class that is taken in it; [] for one state."""
    wanted: dict[int, tuple[int, int]] = {}
    for state in part:
        for edge in range(made.first_edge[state], made.first_edge[state + 1]):
            if made.targets[edge] in part:
                wanted.setdefault(made.taken[edge], (state, made.targets[edge]))
    covered, found, at = 0, [], begin
    for taken, (state, target) in sorted(wanted.items(), key=lambda item: -item[0].bit_count()):
        if taken & ~covered == 0:
            continue
        if at != state:
            found += way(made, at, {state}, part)
        found.append(target)
        at, covered = target, covered | taken
    return found if at == begin else [*found, *way(made, at, {begin}, part)]


def _way_to(
    clock: Clock,
    made: StateSpace,
    numbers: Sequence[int],
    last: Step | None,
    repeats: bool = False,
    first: int = -1,
) -> Counterexample:
    """The run through these states, with its steps found again, and a last step behind it."""
    states = [made.states[number] for number in numbers]
    steps = [next(step for step in clock.steps(before) if step.state == after) for before, after in pairwise(states)]
    if last is not None:
        states.append(last.state)
        steps.append(last)
    repeats_from = -1 if not repeats else first if first >= 0 else len(states) - 1
    return Counterexample(tuple(states), tuple(steps), repeats_from)
