"""Smaller counterexamples: events that are not needed are left out by delta debugging (Zeller and Hildebrandt, 2002).

A smaller run has some of the events of the larger one, in their order, and as few steps as these need. It is a run of
the model that breaks the same property: `RunSearch` follows the model, and whatever it finds is one. Ticks are no
events here, so agents may tick as often as it takes.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from kitrobot.verifier.model.model import State
from kitrobot.verifier.properties.verdicts import Counterexample, Step
from kitrobot.verifier.report.property_graph import Node, Successor, Successors
from kitrobot.verifier.report.property_memory import Memory, PropertyMemory
from kitrobot.verifier.tables.events import Event, EventKind

MOST_PLACES = 4_000
"""States and places in a run that one search looks at."""
_PAUSE = 4
_TICK = 1 << EventKind.TICK
_NO = -1_000_000

_Place = tuple[State, Memory, int]
"""A state, a memory, and how many of the events have come."""


def events_of(steps: Sequence[Step]) -> list[Event]:
    """The events of a run except ticks."""
    return [event for step in steps for event in step.events if event.what is not EventKind.TICK]


@dataclass(frozen=True)
class RunSearch:
    """Searches a model for a shortest run with given events that breaks a property.

    Attributes:
        successors: the steps of the model.
        memory: the property.
        first: where runs begin.
        is_lost: whether a state and a memory break the property though no step does: a standstill, or a part in which
            a run waits for ever.
    """

    successors: Successors
    memory: PropertyMemory
    first: Node
    is_lost: Callable[[Node], bool]

    def find(self, events: Sequence[Event]) -> Counterexample | None:
        """A shortest run with these events in this order, or only the first of them, that breaks the property.

        None if there is none, or none was found within the limits.
        """
        wanted = list(events)
        return self._search(lambda state, step, count: count + self._coming(state, step, wanted, count), MOST_PLACES)

    def find_with_failures(self, failures: int, most: int) -> Counterexample | None:
        """A shortest run with so many failures at most that breaks the property, among so many states; None: none."""
        model = self.successors.space.model
        least = model.failures - failures

        def count_nothing(state: State, step: Successor, count: int) -> int:
            return 0 if model.shareds()[step.state[0]][0] >= least else -1

        return self._search(count_nothing, most)

    def _search(self, count_events: Callable[[State, Successor, int], int], most: int) -> Counterexample | None:
        """A shortest run that breaks the property, by steps whose count is not negative."""
        begin: _Place = (*self.first, 0)
        if self.is_lost(self.first):
            return Counterexample((self.first[0],), ())
        before: dict[_Place, tuple[_Place, Successor]] = {}
        queue, seen, looked = deque([begin]), {begin}, 0
        interruption = self.successors.space.interruption
        while queue and len(seen) < most:
            if looked % _PAUSE == 0 and interruption():
                return None
            looked += 1
            place = queue.popleft()
            state, memory, count = place
            for step in self.successors.of(state):
                coming = count_events(state, step, count)
                if coming < 0:
                    continue
                following = self.memory.after(memory, state, step.kinds, step.state)
                if following is None or self.is_lost((step.state, following)):
                    return self._run(before, place, step)
                after: _Place = step.state, following, coming
                if after not in seen:
                    seen.add(after)
                    before[after] = place, step
                    queue.append(after)
        return None

    def _coming(self, state: State, step: Successor, wanted: list[Event], count: int) -> int:
        """How many of the wanted events come in a step; so much less than none if it has others."""
        if not step.kinds & ~_TICK:
            return 0
        if count == len(wanted) or not step.kinds >> wanted[count].what & 1:
            return _NO
        events = [event for event in self.successors.events(state, step) if event.what is not EventKind.TICK]
        return len(events) if wanted[count : count + len(events)] == events else _NO

    def _run(self, before: dict[_Place, tuple[_Place, Successor]], place: _Place, last: Successor) -> Counterexample:
        states, steps = [last.state], [Step(self.successors.events(place[0], last), last.state)]
        while place in before:
            states.append(place[0])
            earlier, step = before[place]
            steps.append(Step(self.successors.events(earlier[0], step), step.state))
            place = earlier
        return Counterexample((place[0], *states[::-1]), tuple(steps[::-1]))


def minimize_run(run: Counterexample, search: RunSearch) -> Counterexample:
    """A run with as few of the events of a run as possible: none of them can be left out alone, within the limits.

    Args:
        run: the run up to where it breaks the property, without the part that repeats.
        search: where smaller ones are looked for.
    """
    best = search.find(events_of(run.steps)) or run
    for group in _groups(events_of(best.steps)):
        smaller = search.find([event for event in events_of(best.steps) if not group(event)])
        best = smaller or best
    best = _without_late_events(best, search)
    size = len(events_of(best.steps)) // 2
    while size > 0:
        at, is_smaller = 0, False
        while at < len(events := events_of(best.steps)):
            smaller = search.find([*events[:at], *events[at + size :]])
            best, at, is_smaller = (smaller, at, True) if smaller else (best, at + size, is_smaller)
        size = size if size == 1 and is_smaller else size // 2
    return best


def _without_late_events(run: Counterexample, search: RunSearch) -> Counterexample:
    """The run in which each agent does no more from an event of its own on, as early as that can be."""
    best = run
    for agent in dict.fromkeys(event.agent for event in events_of(run.steps)):
        own = [at for at, event in enumerate(events_of(best.steps)) if event.agent == agent]
        for begin in own:
            rest = [event for at, event in enumerate(events_of(best.steps)) if at < begin or event.agent != agent]
            if smaller := search.find(rest):
                best = smaller
                break
    return best


def _groups(events: Sequence[Event]) -> list[Callable[[Event], bool]]:
    """What is left out together at first: failures, then all of an agent, and both for a single agent."""
    agents = list(dict.fromkeys(event.agent for event in events))
    groups: list[Callable[[Event], bool]] = [is_fault]
    groups += [lambda event, i=agent: event.agent == i and is_fault(event) for agent in agents]  # type: ignore[misc]
    groups += [lambda event, i=agent: i in (event.agent, _other(event)) for agent in agents]  # type: ignore[misc]
    return groups


def _other(event: Event) -> int:
    """The other agent of a move; -1 for none."""
    return event.agent if isinstance(event.what, EventKind) else event.other


def is_fault(event: Event) -> bool:
    """Whether an event is a failure, or follows from one."""
    return event.what in _OF_FAULTS


_OF_FAULTS = {
    EventKind.FAIL,
    EventKind.STALL,
    EventKind.MUTE,
    EventKind.RESUME,
    EventKind.MISSED,
    EventKind.FREED,
}
