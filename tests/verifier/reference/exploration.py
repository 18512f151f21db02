"""Breadth-first exploring: every state that can be reached, how it was reached first, and the steps between them."""

from __future__ import annotations

import time
from array import array
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, field

from tests.verifier.reference.events import ModelTooLargeError
from tests.verifier.reference.model import State
from tests.verifier.reference.timing import Clock, Step

_LOOK_EVERY = 1024


@dataclass(frozen=True)
class Budget:
    """How far to explore.

    Attributes:
        states: at most so many.
        seconds: at most so long, on the clock on the wall; None for no limit.
        stop: asked now and then whether to break off.
        progress: told now and then how many states there are and how deep.
    """

    states: int = 1_000_000
    seconds: float | None = None
    stop: Callable[[], bool] = lambda: False
    progress: Callable[[int, int], None] = lambda states, depth: None


@dataclass
class StateSpace:
    """What was explored.

    Attributes:
        states: every state that was reached, in the order of their distance from the first.
        parents: of each the number of the state from which it was reached first; -1 of the first.
        first_edge: steps out of state n are `first_edge[n]` … `first_edge[n + 1]` - 1, where they were kept.
        targets, taken: of each step the state after it and its progress classes (see `timing`).
        idle: of each state the progress classes that it cannot put off.
        forward, backward: of each state the agents that roll that way, as bits.
        depth: steps to the state that is furthest away.
        complete: whether there is no state beyond.
        seconds: how long it took.
    """

    states: list[State] = field(default_factory=list)
    parents: array[int] = field(default_factory=lambda: array("q"))
    first_edge: array[int] = field(default_factory=lambda: array("q", [0]))
    targets: array[int] = field(default_factory=lambda: array("q"))
    taken: list[int] = field(default_factory=list)
    idle: list[int] = field(default_factory=list)
    forward: list[int] = field(default_factory=list)
    backward: list[int] = field(default_factory=list)
    depth: int = 0
    complete: bool = False
    seconds: float = 0.0

    def path(self, number: int) -> list[int]:
        """The numbers of the states on a shortest way to a state, from the first one on."""
        found = []
        while number >= 0:
            found.append(number)
            number = self.parents[number]
        return found[::-1]


Looking = Callable[[int, State, Step | None, State], bool]
"""Told the number of a state, the state, a step out of it (None: the state itself) and the state after it; whether the
search may go on.
"""


def explore(clock: Clock, budget: Budget, looking: Looking, keeps_steps: bool) -> StateSpace:
    """Explores the states of a model.

    Args:
        clock: the steps of the model.
        budget: how far.
        looking: shown every state and step, once.
        keeps_steps: whether steps are kept, as judging what happens in the end needs them.
    """
    began = time.monotonic()
    made = StateSpace()
    with suppress(ModelTooLargeError):
        _explore(clock, budget, looking, keeps_steps, made, began)
    made.seconds = time.monotonic() - began
    budget.progress(len(made.states), made.depth)
    return made


def _explore(clock: Clock, budget: Budget, looking: Looking, keeps_steps: bool, made: StateSpace, began: float) -> None:
    numbers: dict[State, int] = {clock.first: 0}
    masks: dict[int, int] = {}  # so that each is kept once
    made.states.append(clock.first)
    made.parents.append(-1)
    level_end = 1
    for at, state in enumerate(made.states):
        if at == level_end:
            made.depth += 1
            level_end = len(made.states)
        if at % _LOOK_EVERY == 0:
            budget.progress(len(made.states), made.depth)
            if budget.stop():
                return
        if not looking(at, state, None, state):
            return
        for step in clock.steps(state):
            if budget.seconds is not None and time.monotonic() - began > budget.seconds:
                return
            if not looking(at, state, step, step.state):
                return
            number = numbers.get(step.state)
            if number is None:
                if len(made.states) >= budget.states:
                    return
                number = numbers[step.state] = len(made.states)
                made.states.append(step.state)
                made.parents.append(at)
            if keeps_steps:
                made.targets.append(number)
                made.taken.append(masks.setdefault(step.taken, step.taken))
        if keeps_steps:
            made.first_edge.append(len(made.targets))
            idle, (forward, backward) = clock.idle(state), clock.rolling(state)
            made.idle.append(masks.setdefault(idle, idle))
            made.forward.append(forward)
            made.backward.append(backward)
    made.complete = True
