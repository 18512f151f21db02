"""Verdicts: explores the states of a model under one assumption and decides every property on them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from enum import Enum
from typing import NamedTuple

from kitrobot.verifier.budget import Budget, CutReason
from kitrobot.verifier.engines import Engine
from kitrobot.verifier.events import Event
from kitrobot.verifier.exploration import StateSpace, explore
from kitrobot.verifier.fair_cycles import find_fair_cycle, find_first, find_first_crossing, holds_somewhere
from kitrobot.verifier.model import Model, State
from kitrobot.verifier.properties import Property
from kitrobot.verifier.standstill import find_standstill
from kitrobot.verifier.timing import Timing


class Answer(Enum):
    """What came of checking one property."""

    HOLDS = "holds"
    BROKEN = "broken"
    NOT_FINISHED = "not finished"
    VACUOUS = "vacuous"


class Step(NamedTuple):
    """A step of a run: what happens, and the state after it."""

    events: tuple[Event, ...]
    state: State


@dataclass(frozen=True)
class Counterexample:
    """A run of the model: the states in order, the steps between them, and the state from which on it repeats (-1: it
    does not). After the last one nothing happens any more, at most programs go round (see `standstill`).
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
        counterexample: a run that breaks it; None unless there is one.
    """

    property: Property
    answer: Answer
    counterexample: Counterexample | None = None


@dataclass(frozen=True)
class CheckResult:
    """The verdicts under one assumption.

    Attributes:
        timing, failures: the assumption.
        verdicts: one for each property.
        states: how many states were reached.
        depth: steps to the one furthest away.
        cut: why answers are not finished; None where all are.
        complete: whether there are no more states.
        seconds: how long exploring took.
        memory: bytes that states, steps and tables took.
    """

    timing: Timing
    failures: int
    verdicts: tuple[Verdict, ...]
    states: int
    depth: int
    complete: bool
    seconds: float
    memory: int = 0
    cut: CutReason | None = None


_PLAIN_JUDGING, _JUDGING = 12, 48
"""Bytes for each state that judging takes: marks, and the states that are calm; and where something is waited for what
a search through all of them keeps.
"""
_SHARE = 0.75
"""Of the time, for exploring where steps are kept; the rest is for what happens in the end."""


def check_properties(
    model: Model, properties: Sequence[Property], budget: Budget, engine: Engine | None = None
) -> CheckResult:
    """Explores a model, of which nothing was explored yet, and judges properties by it."""
    keeps_steps = any(one.keeps_steps for one in properties)
    began = budget.clock()
    share = None if budget.seconds is None else budget.seconds * (_SHARE if keeps_steps else 1.0)
    reserve = _JUDGING if any(one.waits is not None for one in properties) else _PLAIN_JUDGING
    space = explore(model, replace(budget, seconds=share), keeps_steps, engine, reserve)
    space.interruption = budget.interruption(began)
    first = space.first_occurrences()
    # What one state or event breaks is found at once; what is waited for takes the time that is left.
    quick_first = sorted(range(len(properties)), key=lambda n: properties[n].waits is not None)
    judged: dict[int, Verdict] = {}
    cut = space.cut
    for n in quick_first:
        judged[n] = _verdict(space, properties[n], first)
        cut = cut or space.interrupted_by
    verdicts = [judged[n] for n in range(len(properties))]
    return CheckResult(
        model.timing,
        model.failures,
        tuple(verdicts),
        len(space),
        space.depth,
        space.complete,
        space.seconds,
        space.memory,
        cut,
    )


def _verdict(space: StateSpace, one: Property, first: dict[int, int]) -> Verdict:
    space.begin_property()
    kinds = [what for what in one.broken_by if what in first]
    if kinds:
        kind = min(kinds, key=lambda what: (first[what], what))
        path = space.path(first[kind])
        last = next(n for n, (_, _, came) in enumerate(space.steps(path[-1])) if came >> kind & 1)
        return Verdict(one, Answer.BROKEN, _counterexample_to(space, path, last))
    counterexample = _find_safety_violation(space, one) or _find_liveness_violation(space, one)
    if counterexample is not None:
        return Verdict(one, Answer.BROKEN, counterexample)
    in_question = space.complete and _is_concerned(space, one, first)
    if not space.complete or space.interrupted_by is not None:
        return Verdict(one, Answer.NOT_FINISHED)
    return Verdict(one, Answer.HOLDS if in_question else Answer.VACUOUS)


def _is_concerned(space: StateSpace, one: Property, first: dict[int, int]) -> bool:
    """Whether what a property is about came up."""
    if not one.about and one.concerned is None:
        return True
    if any(what in first for what in one.about):
        return True
    return one.concerned is not None and holds_somewhere(space, one.concerned)


def _find_safety_violation(space: StateSpace, one: Property) -> Counterexample | None:
    """A run that breaks a property by a state, or by a step from one to another."""
    if one.never is not None:
        number = find_first(space, one.never)
        return None if number < 0 else _counterexample_to(space, space.path(number))
    if one.breaks is not None:
        number, step = find_first_crossing(space, *one.breaks)
        return None if number < 0 else _counterexample_to(space, space.path(number), step)
    return None


def _find_liveness_violation(space: StateSpace, one: Property) -> Counterexample | None:
    """A run that breaks a property by standing still or by waiting for ever."""
    if one.is_wrong is not None:
        number = find_standstill(space, one.is_wrong)
        return None if number < 0 else _counterexample_to(space, space.path(number), repeats=True)
    if one.waits is None:
        return None
    lead, around = find_fair_cycle(space, one)
    if not around:
        return None
    path = [*space.path(lead[0]), *lead[1:]]
    return _counterexample_to(space, [*path, *around[1:]], repeats=True, first=len(path) - 1)


def _counterexample_to(
    space: StateSpace, numbers: Sequence[int], last: int = -1, repeats: bool = False, first: int = -1
) -> Counterexample:
    """The run through these states, with its steps found again, and a step out of the last one (-1: none)."""
    states = [space.state(number) for number in numbers]
    steps = []
    for number, after in zip(numbers, states[1:], strict=False):
        which = next(n for n, (state, _, _) in enumerate(space.steps(number)) if state == after)
        steps.append(Step(space.events(number, which), after))
    if last >= 0:
        after = [state for state, _, _ in space.steps(numbers[-1])][last]
        steps.append(Step(space.events(numbers[-1], last), after))
        states.append(after)
    repeats_from = -1 if not repeats else first if first >= 0 else len(states) - 1
    return Counterexample(tuple(states), tuple(steps), repeats_from)
