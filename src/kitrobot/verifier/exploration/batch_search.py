"""Breadth-first search in batches: workers, the tables of each, and the rounds that they go through together.

A worker reads the tables of the model, which all share, and has its own registers and scratch. What only the owner of
the tables may add, it reports as missing; the round pauses, the owner adds it, and the worker goes on. The functions of
a round are those of `step_batches`, or of `state_filter` for an approximate search.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from typing import Any, Protocol

from kitrobot.verifier.exploration.engines import Engine
from kitrobot.verifier.exploration.state_filter import BLOCK
from kitrobot.verifier.exploration.step_batches import WINDOW
from kitrobot.verifier.model.model import Model
from kitrobot.verifier.tables import columns as v
from kitrobot.verifier.tables.dynamic_arrays import grow_table
from kitrobot.verifier.tables.events import ModelTooLargeError
from kitrobot.verifier.tables.tables import Graph, StateFilter, StepBatch, Tables

_STATES = 16_384
"""States of a batch for each worker: much more work than beginning a round, and few enough for the caches of a core."""
_STEPS_EACH = 8
"""Steps that there is room for at first, for each state of a batch."""
_MOST_STEPS = 1 << 20
"""Steps of a worker from which on a batch that has no room for them has fewer states instead."""
_OWN_ROOM = 2 * WINDOW
"""Numbers of `StepBatch.own` for each worker; parts of memory that two write lie apart."""
_OWN = (
    *("regs", "made", "now", "seen", "line", "faults", "after_heads", "after_slots", "after"),
    *("next_x", "next_y", "next_taken", "next_kinds", "next_slots", "next_event", "events"),
)
"""The tables that each worker has for itself."""


class BatchSpace(Protocol):
    """What is explored in batches (see `exploration.StateSpace`)."""

    model: Model
    graph: Graph
    engine: Engine

    def fill(self, code: int) -> None:
        """Adds what a pause code asks for."""

    def look_at_steps(self, batches: BatchSearch) -> None:
        """Called with each gathered batch before its states are numbered."""


class Worker:
    """One worker's share of a batch.

    Attributes:
        tables: those that all share, with its own registers and scratch.
        end: the number of the state behind its share.
        begin: its region's first step in the batch.
        until: the end of its steps.
    """

    def __init__(self, tables: Tables, begin: int) -> None:
        self.tables = _own_tables(tables)
        self.begin = self.until = begin
        self.end = 0
        self._shared = tables

    def take(self, tables: Tables, first: int, end: int, room: int) -> None:
        """Begins its share of a batch: the states from `first` to before `end`."""
        cached = [int(self.tables.regs[n]) for n in _CACHED]
        if tables is not self._shared:
            self._shared = tables
            if any(len(getattr(tables, name)) != len(getattr(self.tables, name)) for name in _OWN):
                self.tables, cached = _own_tables(tables), [0] * len(_CACHED)
            else:
                self.tables = tables._replace(**{name: getattr(self.tables, name) for name in _OWN})
        regs = self.tables.regs
        regs[:] = tables.regs
        for n, value in zip(_CACHED, cached, strict=True):
            regs[n] = value
        regs[v.IS_WORKER], regs[v.GATHERS], regs[v.LEFT_OUT] = 1, v.GATHERS_ALL, 0
        regs[v.GATHER_AT], regs[v.GATHERED], regs[v.STEP_ROOM] = first, self.begin, self.begin + room
        if int(regs[v.AFTER_ROWS]) * v.AFTER * 2 > len(self.tables.after):
            self.forget_after()
        self.end = end

    def forget_after(self) -> None:
        """Empties its cache `after`, which is nearly full or of another layout."""
        self.tables.regs[v.AFTERS] = self.tables.regs[v.AFTER_ROWS] = 0
        self.tables.after_slots[:] = [0] * len(self.tables.after_slots)


_CACHED = (v.AFTERS, v.AFTER_ROWS, v.NEXTS)
"""The registers that belong to a worker's scratch."""


def _own_tables(tables: Tables) -> Tables:
    """The tables with copies of what each worker has for itself, and with empty caches."""
    own = {name: grow_table(getattr(tables, name)[:0], len(getattr(tables, name))) for name in _OWN}
    return tables._replace(**own)


class BatchSearch:
    """Explores a space in batches.

    Args:
        space: what is explored; its engine does not change any more.
        cores: how many workers there are.
        kept: the filter of an approximate search; None for an exact one.
        sums: makes `StepBatch.sums` for the present layout; for an approximate search only.
    """

    def __init__(
        self, space: BatchSpace, cores: int, kept: StateFilter | None = None, sums: Callable[[], Any] | None = None
    ) -> None:
        self._space = space
        self.kept = kept
        self._sums = sums
        self._cores = cores
        self._states = cores * _STATES
        self._room = _STATES * _STEPS_EACH
        self._layout = space.model.layout
        self.batch: StepBatch
        self._end = -1
        self._is_gathered = False
        self._is_refused = False
        self._pool = ThreadPoolExecutor(cores, "search") if cores > 1 and space.engine.is_parallel else None
        self._make_room()

    def close(self) -> None:
        """Ends the threads."""
        if self._pool is not None:
            self._pool.shutdown()

    @property
    def memory(self) -> int:
        """Bytes of the batch."""
        return len(self.batch.x) * 36 + self._states * 13

    @property
    def coming(self) -> int:
        """How many states the batch may add at most; 0 before its steps are known."""
        return sum(worker.until - worker.begin for worker in self._workers) if self._is_gathered else 0

    def steps(self) -> Iterator[tuple[int, int, int, int]]:
        """Of the gathered batch the first state of each worker, the one behind its last, and so of its steps."""
        first = int(self._space.model.t.regs[v.AT])
        for worker in self._workers:
            yield first, worker.end, worker.begin, worker.until
            first = worker.end

    def _make_room(self) -> None:
        engine, size = self._space.engine, self._cores * self._room
        sums = engine.words(0) if self._sums is None else self._sums()
        self.batch = StepBatch(
            x=engine.words(size),
            y=engine.words(size),
            places=engine.words(size),
            targets=engine.words(size),
            taken=engine.zeros(size),
            begins=engine.zeros(self._states),
            ends=engine.zeros(self._states),
            kinds=engine.zeros(self._states),
            calm=engine.bytes(self._states),
            own=engine.words(self._cores * _OWN_ROOM),
            sums=sums,
        )
        self._workers = [Worker(self._space.model.t, n * self._room) for n in range(self._cores)]

    def advance(self, until: int) -> int:
        """Goes on exploring up to about the state of this number; why it ended, or GOES_ON.

        After a code, which says what there is no room for, it is called again.
        """
        regs = self._space.model.t.regs
        while int(regs[v.AT]) < min(until, int(regs[v.COUNT])):
            code = self._go_through(until)
            if code != v.GOES_ON:
                return code
        return v.GOES_ON

    def _go_through(self, until: int) -> int:
        """One round, or what is left of it."""
        space = self._space
        if self._is_refused:
            # One state after another: so it ends at the very state at which one core alone does.
            return int(space.engine.explore_states(space.model.t, space.graph, self.batch, until))
        if self._end < 0:
            self._begin(until)
        try:
            if not (self._is_gathered or self._gather()):
                self._forget_batch()
                return v.GOES_ON
            self._is_gathered = True
        except ModelTooLargeError:
            if self.kept is not None:
                raise
            self._is_refused = True
            self._forget_batch()
            return v.GOES_ON
        regs = space.model.t.regs
        if self.kept is None and int(regs[v.COUNT]) + self.coming > int(regs[v.MOST]):
            self._is_refused = True
            self._forget_batch()
            return v.GOES_ON
        code = self._room_code()
        if code == v.GOES_ON:
            space.look_at_steps(self)
            code = self._commit()
            self._forget_batch()
        return code

    def _forget_batch(self) -> None:
        self._end, self._is_gathered = -1, False

    def _begin(self, until: int) -> None:
        """Shares a batch out; it ends at the end of a level at the latest."""
        regs = self._space.model.t.regs
        at = int(regs[v.AT])
        if at == regs[v.LEVEL_END]:
            regs[v.DEPTH] += 1
            regs[v.LEVEL_END] = regs[v.COUNT]
        if self._space.model.layout is not self._layout:
            self._layout = self._space.model.layout
            for worker in self._workers:
                worker.forget_after()
            if self._sums is not None:
                self.batch = self.batch._replace(sums=self._sums())
        self._is_gathered = False
        self._end = min(at + self._states, int(regs[v.LEVEL_END]))
        count = self._end - at
        regs[v.BATCH_FIRST] = at
        for n, worker in enumerate(self._workers):
            first, end = at + count * n // self._cores, at + count * (n + 1) // self._cores
            worker.take(self._space.model.t, first, end, self._room)

    def _gather(self) -> bool:
        """Gathers the steps of the batch; False if it has to begin anew."""
        space = self._space
        regs = space.model.t.regs

        def gather(worker: Worker) -> int:
            return int(space.engine.explore_states(worker.tables, space.graph, self.batch, worker.end))

        # One worker alone adds to the tables what they lack.
        codes = list(self._each(gather, self._workers)) if self._cores > 1 else [v.GOES_ON]
        if v.ROOM_STEPS in codes:
            self._more_room()
            return False
        first = int(regs[v.AT])
        regs[v.GATHERS] = v.GATHERS_LEFT_OUT if self._cores > 1 else v.GATHERS_ALL
        try:
            for worker in self._workers:
                theirs = worker.tables.regs
                regs[v.GATHER_AT], regs[v.GATHERED], regs[v.STEP_ROOM] = first, theirs[v.GATHERED], theirs[v.STEP_ROOM]
                first = worker.end
                if (theirs[v.LEFT_OUT] or self._cores == 1) and not self._gather_left_out(worker.end):
                    return False
                worker.until = (
                    int(regs[v.GATHERED]) if self._cores == 1 or theirs[v.LEFT_OUT] else int(theirs[v.GATHERED])
                )
        finally:
            regs[v.GATHERS] = 0
        return True

    def _gather_left_out(self, end: int) -> bool:
        """Gathers what a worker left out, and adds to the tables what it lacked; False if the batch begins anew."""
        space = self._space
        while True:
            code = int(space.engine.explore_states(space.model.t, space.graph, self.batch, end))
            if code == v.GOES_ON:
                return True
            if code == v.ROOM_STEPS:
                self._more_room()
                return False
            space.fill(code)
            if space.model.layout is not self._layout:
                return False

    def _more_room(self) -> None:
        if self._room >= _MOST_STEPS and self._states > self._cores:
            self._states = max(self._cores, self._states // 4)
        else:
            self._room *= 2
        self._make_room()

    def _room_code(self) -> int:
        """What there is no room for, or GOES_ON."""
        regs, graph, coming = self._space.model.t.regs, self._space.graph, self.coming
        count, states = int(regs[v.COUNT]), self._end - int(regs[v.AT])
        if int(regs[v.CALMS]) + states > len(graph.calm):
            return v.ROOM_CALM
        if self.kept is not None:
            kept = self.kept
            room = min(len(kept.births) - self._end, len(kept.picks) - count - coming)
            room = min(room, len(graph.x) - (count - int(regs[v.BASE])) - coming)
            return v.ROOM_STATES if min(room, len(kept.wide) - int(kept.counts[0]) - 2 * states) < 0 else v.GOES_ON
        if count + coming > len(graph.x) or (count + coming) * 10 > len(graph.slots) * 7:
            return v.ROOM_STATES
        is_full = int(regs[v.EDGES]) + coming > len(graph.targets) or self._end + 1 > len(graph.first_edge)
        return v.ROOM_EDGES if regs[v.KEEPS] and is_full else v.GOES_ON

    def _commit(self) -> int:
        """Inserts and numbers the states after the steps of the batch."""
        space, batch = self._space, self.batch
        engine, graph, two = space.engine, space.graph, space.model.layout.words == 2
        regions = [(worker.begin, worker.until) for worker in self._workers]

        def insert(n: int) -> None:
            for first, end in regions:
                if self.kept is None:
                    low, high = _share(len(graph.slots), n, self._cores)
                    engine.insert_steps(graph, batch, first, end, low, high, n * _OWN_ROOM, two)
                else:
                    low, high = _share(len(self.kept.bits) // BLOCK, n, self._cores)
                    engine.filter_steps(self.kept, batch, first, end, low, high, n * _OWN_ROOM)

        list(self._each(insert, list(range(self._cores))))
        if self.kept is None:
            return int(engine.number_steps(space.model.t, graph, batch, self._end))
        return int(engine.queue_steps(space.model.t, graph, batch, self.kept, self._end))

    def _each(self, task: Callable[[Any], Any], of: list[Any]) -> Iterator[Any]:
        """Does a task for each of these, beside each other where that is possible."""
        if self._pool is None or len(of) < 2:
            return map(task, of)
        return self._pool.map(task, of)


def _share(size: int, n: int, of: int) -> tuple[int, int]:
    """The begin and the end of part n of a table that is divided into so many."""
    return size * n // of, size * (n + 1) // of


def empty_batch(engine: Engine) -> StepBatch:
    """The batch of a search without batches."""
    words, numbers = engine.words(0), engine.zeros(0)
    return StepBatch(words, words, words, words, numbers, numbers, numbers, numbers, engine.bytes(0), words, words)
