"""When agents tick: three assumptions, of which every verdict names its own.

- *lockstep*: all tick at once, and between two ticks arms end and robots move, as in the simulator;
- *prompt*: every agent ticks at least once between two events of the world;
- *free*: an agent may lag behind the others for as long as it likes.

In the last two any agents may tick in the same moment, too: they read what was there before it. Such a step is made
where no order of their ticks comes to the same. In each of them a robot that drives has a tick of its own in each zone
and at each class of gap (see `bodies`).

A *step* is an edge of the graph that is explored: events, and the progress classes they belong to, as bits. The classes
of agent i of n are its ticks (bit i), that it begins to roll (n + i), the end of what takes it longer (2 n + i), and
that it comes into another zone (3 n + i). None of the first three is put off for ever; and a robot that rolls one way
again and again comes into another zone again and again.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from enum import Enum
from itertools import chain, combinations, islice, product
from typing import NamedTuple

from tests.verifier.reference.bodies import FAILED
from tests.verifier.reference.events import MOST_AT_ONCE, Event, EventKind, ModelTooLargeError, progress
from tests.verifier.reference.model import Model, State
from tests.verifier.reference.motion import Move


class Timing(Enum):
    """An assumption about when agents tick."""

    LOCKSTEP = "lockstep"
    PROMPT = "prompt"
    FREE = "free"


class Step(NamedTuple):
    """An edge: what happens, which progress classes that takes, and the state after it."""

    events: tuple[Event, ...]
    taken: int
    state: State


class Clock:
    """The steps of a model under one assumption; a state of *prompt* has one number more: who has a tick to make."""

    def __init__(self, model: Model, timing: Timing) -> None:
        self.model = model
        self.timing = timing
        self.count = model.count
        self._everyone = range(model.count)
        self._after: dict[State, tuple[tuple[int, State], ...]] = {}
        fastest = min((part.agent.period for part in model.parts), default=1)
        self._slower = [i for i, part in enumerate(model.parts) if part.agent.period > fastest]

    @property
    def first(self) -> State:
        """The first state."""
        if self.timing is Timing.PROMPT:
            return self._waiting((*self.model.first, 0), -1)
        return self.model.first

    def steps(self, state: State) -> Iterator[Step]:
        """The steps out of a state."""
        return self._moments(state) if self.timing is Timing.LOCKSTEP else self._interleaved(state)

    def idle(self, state: State) -> int:
        """The progress classes that a state cannot put off: what is disabled there, and ticks that change nothing."""
        model, count = self.model, self.count
        found = (1 << 3 * count) - 1
        for i in self._everyone:
            lags = self.timing is not Timing.LOCKSTEP or i in self._slower
            if lags and model.ticks(state, i) and not model.stays(state, i):
                found &= ~(1 << i)
            inside = model.inside(state, i)
            if any(inside.busy) and inside.down != FAILED:
                found &= ~(1 << 2 * count + i)
        for road, traffic in enumerate(model.traffic):
            for event, _ in traffic.moves(state[model.roads_at + road]):
                if event.what is Move.BEGIN and not traffic.is_last(state[model.roads_at + road], event.agent):
                    found &= ~(1 << count + event.agent)
        return found

    def rolling(self, state: State) -> tuple[int, int]:
        """The agents that get on forward, and those that get on backward, as bits."""
        forward = backward = 0
        for road, traffic in enumerate(self.model.traffic):
            ways = traffic.rolling(state[self.model.roads_at + road])
            forward, backward = forward | ways[0], backward | ways[1]
        return forward, backward

    # -- lockstep

    def moments(self, state: State) -> Iterator[tuple[State, tuple[Event, ...], int]]:
        """What can be between two ticks of all, in the order of the simulator: what takes longer ends, robots move; the
        state then, the events, and their progress classes.
        """
        model = self.model
        for ended, events, taken in self._ended(state):
            roads = (traffic.moment(ended[model.roads_at + road]) for road, traffic in enumerate(model.traffic))
            for moments in product(*roads):
                moved = list(ended)
                happened, further = events, taken
                for road, (passed, came, number) in enumerate(moments):
                    moved[model.roads_at + road] = number
                    happened += passed
                    further |= came
                yield tuple(moved), happened, further

    def _moments(self, state: State) -> Iterator[Step]:
        found: set[tuple[State, int]] = set()
        may_befall = state[self.model.failures_at] > 0 or any(True for _ in self.model.failures(state))
        for moved, happened, taken in self.moments(state):
            for befallen, what in self._befallen(moved) if may_befall else ((moved, ()),):
                ticked = self._after.get(befallen)
                if ticked is None:
                    ticked = self._after[befallen] = tuple(islice(self._ticked(befallen), MOST_AT_ONCE + 1))
                    if len(ticked) > MOST_AT_ONCE:
                        raise ModelTooLargeError
                for slower, after in ticked:
                    if (after, taken | slower) not in found:
                        found.add((after, taken | slower))
                        yield Step((*happened, *what), taken | slower, after)

    def _ended(self, state: State) -> Iterator[tuple[State, tuple[Event, ...], int]]:
        """After none, some or all of what takes longer has ended."""
        waiting: list[tuple[State, tuple[Event, ...], int]] = [(state, (), 0)]
        while waiting:
            now, events, taken = waiting.pop()
            yield now, events, taken
            for event, after in self.model.ends(now):
                if not events or event.agent > events[-1].agent:
                    waiting.append((after, (*events, event), taken | progress(event, self.count)))

    def _befallen(self, state: State) -> Iterator[tuple[State, tuple[Event, ...]]]:
        """After nothing befell anybody, or something some of them."""
        waiting: list[tuple[State, tuple[Event, ...]]] = [(state, ())]
        while waiting:
            now, events = waiting.pop()
            yield now, events
            for event, after in self.model.failures(now):
                is_later = not events or event.agent > events[-1].agent
                # Who goes on or stalls may lose its radio in the same moment.
                is_more = (
                    event.what is EventKind.MUTE
                    and not is_later
                    and events[-1].what in (EventKind.RESUME, EventKind.STALL)
                )
                if is_later or (is_more and event.agent == events[-1].agent):
                    waiting.append((after, (*events, event)))

    def _ticked(self, state: State) -> Iterator[tuple[int, State]]:
        """After a tick of all; agents whose ticks are longer than others' may have none. Which of these had one, as
        bits, stands before the state.
        """
        for pauses in product((False, True), repeat=len(self._slower)):
            paused = {i for i, pause in zip(self._slower, pauses, strict=True) if pause}
            ticking = sum(1 << i for i in self._slower if i not in paused)
            for after in self.model.after_all(state, paused):
                yield ticking, after

    # -- prompt and free

    def _interleaved(self, state: State) -> Iterator[Step]:
        model, prompt = self.model, self.timing is Timing.PROMPT
        for i in self._everyone:
            if model.ticks(state, i):
                for after in model.after_tick(state, i):
                    if prompt:
                        after = self._waiting(after, after[-1] & ~(1 << i))
                    yield Step((Event(i, EventKind.TICK),), 1 << i, after)
        writing = [i for i in self._everyone if model.ticks(state, i) and model.writes(state, i)]
        for who in chain.from_iterable(combinations(writing, size) for size in range(2, len(writing) + 1)):
            bits = sum(1 << i for i in who)
            for after in self._at_once(state, who) - self._in_parts(state, who):
                if prompt:
                    after = self._waiting(after, after[-1] & ~bits)
                yield Step((Event(who[0], EventKind.TICK),), bits, after)
        if not prompt or state[-1] == 0:
            for event, after in model.ends(state):
                yield Step((event,), progress(event, self.count), self._due(after))
            for road, traffic in enumerate(model.traffic):
                at = model.roads_at + road
                for event, number in traffic.moves(state[at]):
                    yield Step(
                        (event,), progress(event, self.count), self._due((*state[:at], number, *state[at + 1 :]))
                    )
        for event, after in model.failures(state):
            yield Step((event,), 0, self._waiting(after, after[-1]) if prompt else after)

    def _at_once(self, state: State, who: Collection[int]) -> set[State]:
        """After a tick of these in one moment."""
        return set(self.model.after_all(state, set(self._everyone) - set(who)))

    def _in_parts(self, state: State, who: Collection[int]) -> set[State]:
        """After ticks of some of these in one moment, then of the others."""
        parts = chain.from_iterable(combinations(who, size) for size in range(1, len(who)))
        return {
            after
            for part in parts
            for between in self._at_once(state, part)
            for after in self._at_once(between, set(who) - set(part))
        }

    def _due(self, state: State) -> State:
        """After an event of the world: everyone has a tick to make."""
        return self._waiting(state, -1) if self.timing is Timing.PROMPT else state

    def _waiting(self, state: State, due: int) -> State:
        """The state in which these agents, as bits, have a tick to make; one that would change nothing is made."""
        model = self.model
        left = 0
        for i in self._everyone:
            if due >> i & 1 and model.ticks(state, i) and not model.stays(state, i):
                left |= 1 << i
        return (*state[:-1], left)
