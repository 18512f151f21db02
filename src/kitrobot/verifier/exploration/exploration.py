"""Breadth-first exploration: every reachable state, a shortest path to each, and the steps between them."""

from __future__ import annotations

from array import array
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from typing import Any

from kitrobot.verifier.exploration import engine_policy, engines
from kitrobot.verifier.exploration.batch_search import BatchSearch, empty_batch
from kitrobot.verifier.exploration.budget import Budget, CutReason
from kitrobot.verifier.exploration.engines import Engine
from kitrobot.verifier.exploration.memory import USUAL, resident
from kitrobot.verifier.model.model import Model, State
from kitrobot.verifier.tables import columns as v
from kitrobot.verifier.tables.dynamic_arrays import grow_table
from kitrobot.verifier.tables.events import Event, ModelTooLargeError, event_of
from kitrobot.verifier.tables.tables import Graph

_PAUSE_S = 0.1
"""Seconds of exploration between two polls of the limits."""
_ROOM_AT_FIRST = 16_000_000
"""The initial capacity of arrays, in states; memory is taken only as it is used."""
MOST_STATES = (1 << 31) - 2


@dataclass
class StateSpace:
    """The explored states of a model.

    Attributes:
        model: the model.
        graph: its states and steps.
        engine: the engine that explores and searches them.
        expanded: how many of the states, from the first on, have all their steps.
        cut: why there may be more states; None if there are none.
        seconds: the duration of the exploration.
        interruption: returns why a search has to end now (time, stop); None otherwise.
        interrupted_by: why the search for a property ended early; None if it did not.
        reserve: bytes for each state reserved for the searches after the exploration.
        batches: explores with several workers; None while one is enough.
    """

    model: Model
    graph: Graph
    engine: Engine
    cut: CutReason | None = CutReason.SIZE
    seconds: float = 0.0
    interruption: Callable[[], CutReason | None] = field(default=lambda: None)
    interrupted_by: CutReason | None = None
    reserve: int = 0
    batches: BatchSearch | None = None

    @property
    def complete(self) -> bool:
        """Whether there is no state beyond."""
        return self.cut is None

    def begin_property(self) -> None:
        """Resets `interrupted_by` before the search for another property."""
        self.interrupted_by = None

    def __len__(self) -> int:
        """The number of states."""
        return int(self.model.t.regs[v.COUNT])

    @property
    def expanded(self) -> int:
        """How many of the states, from the first on, have all their steps."""
        return int(self.model.t.regs[v.AT])

    @property
    def depth(self) -> int:
        """Steps to the state that is furthest away."""
        return int(self.model.t.regs[v.DEPTH])

    @property
    def memory(self) -> int:
        """Bytes that states, steps and tables take."""
        regs, graph = self.model.t.regs, self.graph
        states = len(self) * (8 * self.model.layout.words + 4)
        steps = int(regs[v.EDGES]) * 6 + (self.expanded + 1) * 4 if regs[v.KEEPS] else 0
        tables = sum(8 * len(table) for table in self.model.t)
        tables += 0 if self.batches is None else self.batches.memory
        return states + steps + 4 * len(graph.slots) + 4 * int(regs[v.CALMS]) + tables

    @property
    def process_memory(self) -> int:
        """Bytes that the process will have taken when all properties are decided."""
        return (resident() or USUAL + self.memory) + self.reserve * len(self)

    def growth(self, code: int) -> int:
        """Bytes that the process takes, at least for a while, when `fill` is called with this code."""
        # Arrays grow one after another; of what is not used yet nothing is taken.
        if code == v.ROOM_STATES:
            return max(8 * len(self) if self._needs_states() else 0, 4 * len(self.graph.slots))
        if code == v.ROOM_EDGES:
            return 4 * max(int(self.model.t.regs[v.EDGES]), self.expanded)
        if code == v.ROOM_CALM:
            return 4 * int(self.model.t.regs[v.CALMS])
        # Keys may come to need a second word.
        return 8 * len(self) if self.model.layout.words == 1 else 0

    def state(self, number: int) -> State:
        """A state that is kept."""
        graph, at = self.graph, number - int(self.model.t.regs[v.BASE])
        return self.model.layout.state(int(graph.x[at]), int(graph.y[at]) if self.model.layout.words == 2 else 0)

    def advance(self, until: int) -> int:
        """Goes on exploring up to about the state of this number; why it ended, or `GOES_ON`."""
        if self.batches is not None:
            return self.batches.advance(until)
        return int(self.engine.explore_states(self.model.t, self.graph, empty_batch(self.engine), until))

    def may_join(self, cores: int) -> None:
        """Lets so many cores explore from now on, if the engine can use them."""
        if self.batches is None and cores > 1 and self.engine.is_parallel:
            self.batches = BatchSearch(self, cores)

    def look_at_steps(self, batches: BatchSearch) -> None:
        """Called with each gathered batch before its states are numbered; an exact search keeps steps if need be."""

    def use(self, engine: Engine) -> None:
        """Switches to another engine, converting tables and graph."""
        most = min(self.model.t.regs[v.MOST] or _ROOM_AT_FIRST, _ROOM_AT_FIRST)
        self.model.t, self.graph = engine.take(self.model.t, self.graph, int(most))
        self.engine = engine

    def install(self, states: Sequence[State], steps: Sequence[Sequence[tuple[int, int]]], calm: Sequence[int]) -> None:
        """Takes over what was explored elsewhere: states, and of the first ones the steps, each with the number of the
        state after it (one behind all where it is not among them) and its progress classes; and calm states.
        """
        model, count = self.model, len(states)
        keys = [model.layout.key(state) for state in states]
        ends, targets, taken = [0], [], []
        for row in steps:
            targets += [target for target, _ in row]
            taken += [classes for _, classes in row]
            ends.append(len(targets))
        slots = 1 << (2 * count + 4).bit_length()
        self.graph = fresh_graph()._replace(
            x=array("q", [x for x, _ in keys] + [0]),
            y=array("q", [y for _, y in keys] + [0]) if model.layout.words == 2 else array("q"),
            slots=array("i", bytes(4 * slots)),
            first_edge=array("i", [*ends, *[len(targets)] * (count + 2 - len(ends))]),
            targets=array("i", targets or [0]),
            taken=array("H", taken or [0]),
            calm=array("i", calm or [0]),
        )
        regs = model.t.regs
        regs[v.COUNT], regs[v.AT], regs[v.EDGES], regs[v.CALMS] = count, len(steps), len(targets), len(calm)
        regs[v.WORDS], regs[v.BASE] = model.layout.words, 0

    def first_occurrences(self) -> dict[int, int]:
        """For each kind of event that occurred, the first state in which it did."""
        regs = self.model.t.regs
        return {kind: int(regs[v.FIRST_OF + kind]) for kind in range(v.KINDS) if regs[v.SEEN_KINDS] >> kind & 1}

    def path(self, number: int) -> list[int]:
        """The numbers of the states on a shortest path to a state, from the first one on."""
        found = []
        while number >= 0:
            found.append(number)
            number = int(self.graph.parents[number])
        return found[::-1]

    def steps(self, number: int) -> Iterator[tuple[State, int, int]]:
        """The steps out of a state: the state after each, its progress classes by number, its kinds of events."""
        return self.steps_from(self.state(number))

    def steps_from(self, state: State) -> Iterator[tuple[State, int, int]]:
        """The same of any state of the model, explored or not."""
        t = self._expand(state, -1)
        for n in range(int(t.regs[v.NEXTS])):
            after = self.model.layout.state(int(t.next_x[n]), int(t.next_y[n]))
            yield after, int(t.next_taken[n]), int(t.next_kinds[n])

    def events(self, number: int, step: int) -> tuple[Event, ...]:
        """The events of a step out of a state, by its place among those."""
        return self.events_from(self.state(number), step)

    def events_from(self, state: State, step: int) -> tuple[Event, ...]:
        """The same of any state of the model, explored or not."""
        t = self._expand(state, step)
        if t.fixed[v.TIMING] != v.LOCKSTEP:
            return (event_of(int(t.next_event[step])),)
        return tuple(event_of(int(t.events[n])) for n in range(int(t.regs[v.FOUND])))

    def _expand(self, state: State, seek: int) -> Any:
        """Finds the steps out of a state again."""
        while True:
            t = self.model.t
            t.regs[v.SEEK] = seek
            found = self.engine.expand(t, *self.model.layout.key(state))
            t.regs[v.SEEK] = -1
            if found >= 0 or (seek >= 0 and t.fixed[v.TIMING] == v.LOCKSTEP and t.regs[v.FOUND] >= 0):
                return t
            self.fill(int(t.regs[v.CODE]))

    def fill(self, code: int) -> None:
        """Adds the missing entries or room that a pause code asks for, to the tables or the graph.

        Raises:
            ModelTooLargeError: there is no room left.
        """
        before = self.model.layout
        regs = self.model.t.regs
        if code == v.ROOM_STATES:
            self._grow_states()
        elif code == v.ROOM_EDGES:
            self._grow("targets", "taken")
            if int(regs[v.AT]) + max(2, self._coming()) > len(self.graph.first_edge):
                self._grow("first_edge")
        elif code == v.ROOM_CALM:
            self._grow("calm")
        else:
            self.model.fill(code)
        if self.model.layout is not before:
            self._repack(before)

    def _grow(self, *names: str) -> None:
        for name in names:
            table = getattr(self.graph, name)
            self.graph = self.graph._replace(**{name: grow_table(table, 2 * len(table))})

    def _coming(self) -> int:
        """How many states are to find room at once."""
        return max(len(self.model.t.next_x), 0 if self.batches is None else self.batches.coming)

    def _needs_states(self) -> bool:
        return len(self.graph.x) - len(self) < max(2 * len(self.model.t.next_x), self._coming())

    def _grow_states(self) -> None:
        words = self.model.layout.words
        if self._needs_states():
            self._grow("x", "parents", *(("y",) if words == 2 else ()))
        if (len(self) + self._coming()) * 10 > len(self.graph.slots) * 7:
            self._rebuild_slots(2 * len(self.graph.slots))

    def _rebuild_slots(self, size: int) -> None:
        slots = self.graph.slots
        self.graph = self.graph._replace(slots=slots[:0])
        del slots
        self.graph = self.graph._replace(slots=self.engine.zeros(size))
        self.engine.rehash(self.graph, len(self), self.model.layout.words == 2)

    def _repack(self, before: Any) -> None:
        """Rewrites all keys in the new layout."""
        model = self.model
        if model.layout.words == 2 and len(self.graph.y) < len(self.graph.x):
            self.graph = self.graph._replace(y=grow_table(self.graph.y, len(self.graph.x)))
        two = model.layout.words == 2
        rows = self.engine.row(before.rows()), self.engine.row(model.layout.rows())
        kept = len(self) - int(model.t.regs[v.BASE])
        self.engine.repack(self.graph, kept, len(before.word), *rows, before.words == 2, two)
        model.t.regs[v.WORDS] = model.layout.words
        self._rebuild_slots(len(self.graph.slots))


def explore(
    model: Model, budget: Budget, keeps_steps: bool, engine: Engine | None = None, reserve: int = 0
) -> StateSpace:
    """Explores the states of a model.

    Args:
        model: a model that has not been explored.
        budget: the limits.
        keeps_steps: whether steps are stored, as deciding liveness needs them.
        engine: the engine; None for the plain one until the compiled one is available and worth it.
        reserve: bytes of memory for each state to leave free.
    """
    began = budget.clock()
    space = StateSpace(model, fresh_graph(), engines.PLAIN, interruption=budget.interruption(began), reserve=reserve)
    with suppress(ModelTooLargeError):
        begin_exploration(space, MOST_STATES if budget.states is None else min(budget.states, MOST_STATES), keeps_steps)
        if engine is not None:
            space.use(engine)
        space.cut = continue_exploration(space, budget, engine is None)
    if space.batches is not None:
        space.batches.close()
    space.seconds = budget.clock() - began
    if space.engine is engines.PLAIN:
        engine_policy.plain_work.states += len(space)
        engine_policy.plain_work.seconds += space.seconds
    budget.progress(len(space), space.depth)
    return space


def fresh_graph() -> Graph:
    """A graph without states."""

    def numbers(size: int) -> array[int]:
        return array("i", bytes(4 * size))

    def keys(size: int) -> array[int]:
        return array("q", bytes(8 * size))

    return Graph(
        x=keys(4096),
        y=keys(0),
        parents=numbers(4096),
        slots=numbers(8192),
        first_edge=numbers(4096),
        targets=numbers(8192),
        taken=array("H", bytes(2 * 8192)),
        calm=numbers(4096),
    )


def begin_exploration(space: StateSpace, most: int, keeps_steps: bool) -> None:
    """Adds the first state to the graph."""
    model = space.model
    first = model.begin()
    regs = model.t.regs
    regs[v.WORDS] = model.layout.words
    if model.layout.words == 2:
        space.graph = space.graph._replace(y=grow_table(space.graph.y, len(space.graph.x)))
    space.graph.x[0], y = model.layout.key(first)
    if model.layout.words == 2:
        space.graph.y[0] = y
    space.graph.parents[0] = -1
    regs[v.AT], regs[v.COUNT], regs[v.EDGES], regs[v.LEVEL_END], regs[v.DEPTH] = 0, 1, 0, 1, 0
    regs[v.MOST], regs[v.KEEPS], regs[v.SEEK], regs[v.SEEN_KINDS] = most, int(keeps_steps), -1, 0
    space.engine.rehash(space.graph, 1, model.layout.words == 2)


def continue_exploration(space: StateSpace, budget: Budget, may_change: bool) -> CutReason | None:
    """Explores until there are no more states, or a limit is reached; which one."""
    batch, begun = 256, budget.clock()
    reported = begun
    while space.expanded < len(space):
        if cut := space.interruption():
            return cut
        if budget.memory is not None and space.process_memory > budget.memory:
            return CutReason.MEMORY
        if may_change and space.engine is engines.PLAIN:
            better = engine_policy.choose_engine(len(space), budget.clock() - begun)
            # For a moment both copies exist.
            if better is not None and (budget.memory is None or space.process_memory + space.memory < budget.memory):
                space.use(better)
        if len(space) >= budget.alone:
            space.may_join(budget.cores)
        began = budget.clock()
        code = space.advance(space.expanded + batch)
        if code == v.CUT:
            return CutReason.STATES
        if code != v.GOES_ON:
            if budget.memory is not None and space.process_memory + space.growth(code) > budget.memory:
                return CutReason.MEMORY
            space.fill(code)
            continue
        now = budget.clock()
        batch = max(1, min(4 * batch, int(batch * _PAUSE_S / max(now - began, 1e-3))))
        if now - reported > _PAUSE_S:
            reported = now
            budget.progress(len(space), space.depth)
    return None
