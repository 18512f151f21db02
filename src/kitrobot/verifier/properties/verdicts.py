"""Verdicts: explores the states of a model under one assumption and decides every property on them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from enum import Enum
from itertools import pairwise
from typing import NamedTuple

from kitrobot.verifier.exploration.budget import Budget, CutReason
from kitrobot.verifier.exploration.engines import Engine
from kitrobot.verifier.exploration.exploration import StateSpace, explore
from kitrobot.verifier.model.model import Model, State
from kitrobot.verifier.model.timing import Timing
from kitrobot.verifier.properties.fair_cycles import find_fair_cycle, find_first, find_first_crossing, holds_somewhere
from kitrobot.verifier.properties.histories import HISTORY_BYTES, find_broken_history
from kitrobot.verifier.properties.properties import Property
from kitrobot.verifier.properties.standstill import find_standstill
from kitrobot.verifier.tables.events import Event


class Answer(Enum):
    """The result of checking one property."""

    HOLDS = "holds"
    BROKEN = "broken"
    NOT_FINISHED = "not finished"
    VACUOUS = "vacuous"
    NOTHING_FOUND = "nothing found"
    """By an approximate search, which may have omitted states."""
    NOT_DECIDED = "not decided"
    """An approximate search cannot judge it."""


class Step(NamedTuple):
    """A step of a run: its events, and the state after it."""

    events: tuple[Event, ...]
    state: State


@dataclass(frozen=True)
class Counterexample:
    """A run of the model that breaks a property.

    Attributes:
        states: the states in order.
        steps: the steps between them.
        repeats_from: the state from which on the run repeats; -1 if it does not. If that is the last state, nothing
            happens after it except that programs repeat themselves (see `standstill`).
    """

    states: tuple[State, ...]
    steps: tuple[Step, ...]
    repeats_from: int = -1


@dataclass(frozen=True)
class Verdict:
    """The result of one property under one assumption.

    Attributes:
        property: the property.
        answer: never HOLDS if the search ended early.
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
        states: the number of states reached.
        depth: the number of steps to the furthest state.
        cut: why answers are not finished; None if all are.
        complete: whether there are no more states.
        seconds: the duration of the exploration.
        memory: the bytes of states, steps and tables.
        is_approximate: whether states were forgotten, and perhaps omitted.
        odds: of an approximate search, the odds that a state which a step led to was taken for one that had been seen
            (`state_filter.odds_of_omission`); None for an exact one.
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
    is_approximate: bool = False
    odds: float | None = None


_SAFETY_BYTES, _LIVENESS_BYTES = 12, 48
"""Bytes for each state that deciding properties takes: marks and calm states; for liveness also a search."""
_SHARE = 0.75
"""The share of the time for exploring if steps are stored; the rest is for deciding liveness."""


def check_properties(
    model: Model, properties: Sequence[Property], budget: Budget, engine: Engine | None = None
) -> CheckResult:
    """Explores a model that has not been explored, and decides properties on its states."""
    keeps_steps = any(one.keeps_steps for one in properties)
    began = budget.clock()
    share = None if budget.seconds is None else budget.seconds * (_SHARE if keeps_steps else 1.0)
    reserve = _LIVENESS_BYTES if any(one.waits is not None for one in properties) else _SAFETY_BYTES
    reserve = max(reserve, *(HISTORY_BYTES * one.history.size for one in properties if one.history is not None), 0)
    space = explore(model, replace(budget, seconds=share), keeps_steps, engine, reserve)
    space.interruption = budget.interruption(began)
    first = space.first_occurrences()
    # Violations of safety are found at once; liveness takes the time that is left.
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
    """Whether an event or state that the property is about occurred."""
    if not one.about and one.concerned is None:
        return True
    if any(what in first for what in one.about):
        return True
    return one.concerned is not None and holds_somewhere(space, one.concerned)


def _find_safety_violation(space: StateSpace, one: Property) -> Counterexample | None:
    """A run that breaks a property by a state or a step; None for none."""
    if one.never is not None:
        number = find_first(space, one.never)
        return None if number < 0 else _counterexample_to(space, space.path(number))
    if one.breaks is not None:
        number, step = find_first_crossing(space, *one.breaks)
        return None if number < 0 else _counterexample_to(space, space.path(number), step)
    if one.history is not None:
        path = find_broken_history(space, one.history)
        return _counterexample_to(space, path) if path else None
    return None


def _find_liveness_violation(space: StateSpace, one: Property) -> Counterexample | None:
    """A run that breaks a property by standing still or waiting for ever; None for none."""
    if one.is_wrong is not None:
        number = find_standstill(space, one.is_wrong)
        return None if number < 0 else _counterexample_to(space, space.path(number), repeats=True)
    if one.waits is None:
        return None
    for waits in (one.waits, *one.also_waits):
        lead, around = find_fair_cycle(space, replace(one, waits=waits))
        if around:
            break
    if not around:
        return None
    path = [*space.path(lead[0]), *lead[1:]]
    return _counterexample_to(space, [*path, *around[1:]], repeats=True, first=len(path) - 1)


def _counterexample_to(
    space: StateSpace, numbers: Sequence[int], last: int = -1, repeats: bool = False, first: int = -1
) -> Counterexample:
    """Rebuilds the run through these states, with a step out of the last one (-1: none)."""
    return counterexample_through(space, [space.state(number) for number in numbers], last, repeats, first)


def counterexample_through(
    space: StateSpace, states: Sequence[State], last: int = -1, repeats: bool = False, first: int = -1
) -> Counterexample:
    """The run through states that follow each other, with a step out of the last one (-1: none)."""
    found, steps = list(states), []
    for before, after in pairwise(states):
        which = next(n for n, (state, _, _) in enumerate(space.steps_from(before)) if state == after)
        steps.append(Step(space.events_from(before, which), after))
    if last >= 0:
        after = [state for state, _, _ in space.steps_from(states[-1])][last]
        steps.append(Step(space.events_from(states[-1], last), after))
        found.append(after)
    repeats_from = -1 if not repeats else first if first >= 0 else len(found) - 1
    return Counterexample(tuple(found), tuple(steps), repeats_from)
