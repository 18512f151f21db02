"""Every run of a model within its bounds, breadth first: how many states, and the shortest run that breaks a law.

A model gives its first state, the steps from a state, and the laws that a state or a step breaks. States are hashable
values; a state that was reached before is not gone on from again. Because a state is found on a shortest way to it, the
first break that is found is a shortest one.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable
from dataclasses import dataclass
from typing import Generic, NamedTuple, Protocol, TypeVar

State = TypeVar("State", bound=Hashable)


class Step(NamedTuple, Generic[State]):
    """What may happen next: in words, the state after it, and the law that is broken on the way, "" if none."""

    words: Callable[[], str]
    state: State
    broken: str = ""


class Model(Protocol[State]):
    """What is explored."""

    def first(self) -> State:
        """The state in which every run begins."""

    def steps(self, state: State) -> Iterable[Step[State]]:
        """All that may happen next."""

    def broken(self, state: State) -> str:
        """The law that a state breaks; "" if none."""


@dataclass(frozen=True)
class Violation:
    """A law that does not hold, and the events of a shortest run that breaks it, in words."""

    law: str
    events: tuple[str, ...]

    def __str__(self) -> str:
        lines = (f"{number:3}. {event}" for number, event in enumerate(self.events, 1))
        return "\n".join([f"{self.law}: broken after {len(self.events)} events", *lines])


@dataclass(frozen=True)
class Exploration(Generic[State]):
    """The outcome: the states in the order in which they were found.

    Attributes:
        depth: events of the longest of all shortest ways.
        complete: whether every state within the model's bounds was reached.
    """

    states: tuple[State, ...]
    steps: int
    depth: int
    complete: bool
    broken: Violation | None


def explore(model: Model[State], most: int) -> Exploration[State]:
    """Goes through all states that can be reached, or the `most` nearest ones, until a law is broken."""
    first = model.first()
    came: dict[State, tuple[State, Step[State]] | None] = {first: None}
    layer, depth, steps = [first], 0, 0

    def told(state: State, last: Step[State] | None, law: str) -> Exploration[State]:
        events = [last.words()] if last else []
        at = came[state]
        while at is not None:
            events.append(at[1].words())
            at = came[at[0]]
        return Exploration(tuple(came), steps, depth, False, Violation(law, tuple(reversed(events))))

    if law := model.broken(first):
        return told(first, None, law)
    while layer:
        following: list[State] = []
        for state in layer:
            for step in model.steps(state):
                steps += 1
                if step.broken:
                    return told(state, step, step.broken)
                if step.state in came:
                    continue
                if law := model.broken(step.state):
                    return told(state, step, law)
                if len(came) >= most:
                    return Exploration(tuple(came), steps, depth, False, None)
                came[step.state] = state, step
                following.append(step.state)
        layer = following
        depth += bool(layer)
    return Exploration(tuple(came), steps, depth, True, None)
