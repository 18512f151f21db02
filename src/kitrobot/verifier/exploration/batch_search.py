"""Breadth-first search in batches: workers, the tables of each, and the rounds that they go through together.

A worker reads the tables of the model, which all share, and has its own registers and scratch. What only the owner of
the tables may add, it reports as missing; the round pauses, the owner adds it, and the worker goes on. The functions of
a round are those of `step_batches`, or of `state_filter` for an approximate search.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING, Any

from kitrobot.verifier.exploration.engines import Engine
from kitrobot.verifier.exploration.state_filter import BLOCK
from kitrobot.verifier.tables import columns as v
from kitrobot.verifier.tables.dynamic_arrays import grow_table
from kitrobot.verifier.tables.events import ModelTooLargeError
from kitrobot.verifier.tables.tables import StateFilter, StepBatch, Tables

if TYPE_CHECKING:
    from kitrobot.verifier.exploration.exploration import StateSpace

_STATES = 16_384
"""States of a batch for each worker: much more work than beginning a round, and few enough for the caches of a core."""
_STEPS_EACH = 8
"""Steps that there is room for at first, for each state of a batch."""
_MOST_STEPS = 1 << 20
"""Steps of a worker from which on a batch that has no room for them has fewer states instead."""
_OWN = (
    *("regs", "made", "now", "seen", "line", "faults", "after_heads", "after_slots", "after"),
    *("next_x", "next_y", "next_taken", "next_kinds", "next_slots", "next_event", "events"),
)
"""The tables that each worker has for itself."""


class Worker:
    """One worker's share of a batch.

    Attributes:
        tables: those that all share, with its own registers and scratch.
        end: the number of the state behind its share.
        begin: its region's first step in the batch.
    """

    def __init__(self, tables: Tables, begin: int) -> None:
        self.tables = _own_tables(tables)
        self.begin = begin
        self.end = 0
        self._shared = tables

    def take(self, tables: Tables, first: int, end: int, room: int, batch_first: int) -> None:
        """Begins its share of a batch: the states from `first` to before `end`."""
        self._refresh(tables)
        regs = self.tables.regs
        regs[v.AT], regs[v.GATHERED], regs[v.STEP_ROOM] = first, self.begin, self.begin + room
        regs[v.BATCH_FIRST] = batch_first
        self.end = end

    def go_on(self, tables: Tables) -> None:
        """Takes over what the owner of the tables added."""
        regs = self.tables.regs
        kept = [int(regs[n]) for n in _PROGRESS]
        self._refresh(tables)
        for n, value in zip(_PROGRESS, kept, strict=True):
            self.tables.regs[n] = value

    def _refresh(self, tables: Tables) -> None:
        cached = self.tables.regs[v.AFTERS], self.tables.regs[v.AFTER_ROWS], self.tables.regs[v.NEXTS]
        if tables is not self._shared:
            self._shared = tables
            if any(len(getattr(tables, name)) != len(getattr(self.tables, name)) for name in _OWN):
                self.tables, cached = _own_tables(tables), (0, 0, 0)
            else:
                own = {name: getattr(self.tables, name) for name in _OWN}
                self.tables = tables._replace(**own)
        regs = self.tables.regs
        regs[:] = tables.regs
        regs[v.IS_WORKER] = regs[v.GATHERS] = 1
        regs[v.AFTERS], regs[v.AFTER_ROWS], regs[v.NEXTS] = cached

    def forget_after(self) -> None:
        """Empties its cache `after`, which is full or of another layout."""
        self.tables.regs[v.AFTERS] = self.tables.regs[v.AFTER_ROWS] = 0
        self.tables.after_slots[:] = [0] * len(self.tables.after_slots)


_PROGRESS = (
    *(v.AT, v.GATHERED, v.STEP_ROOM, v.BATCH_FIRST, v.SEEN_KINDS),
    *range(v.FIRST_OF, v.FIRST_OF + v.KINDS),
)
"""The registers that say how far a worker is with its share."""


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
        self, space: StateSpace, cores: int, kept: StateFilter | None = None, sums: Callable[[], Any] | None = None
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
        return len(self.batch.x) * 36 + self._states * 5

    @property
    def coming(self) -> int:
        """How many states the batch may add at most; 0 before its steps are known."""
        return sum(int(worker.tables.regs[v.GATHERED]) - worker.begin for worker in self._workers) if self._end >= 0 else 0

    def steps(self) -> Iterator[tuple[int, int, int, int]]:
        """Of the gathered batch the first state of each worker, the one behind its last, and so of its steps."""
        first = int(self._space.model.t.regs[v.AT])
        for worker in self._workers:
            yield first, worker.end, worker.begin, int(worker.tables.regs[v.GATHERED])
            first = worker.end

    def _make_room(self) -> None:
        engine, size = self._space.engine, self._cores * self._room
        sums = engine.words(0) if self._sums is None else self._sums()
        self.batch = StepBatch(
            *(engine.words(size) for _ in range(4)),
            *(engine.zeros(size), engine.zeros(self._states), engine.bytes(self._states), sums),
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
            if not self._gather():
                self._end = -1
                return v.GOES_ON
        except ModelTooLargeError:
            if self.kept is not None:
                raise
            self._is_refused, self._end = True, -1
            return v.GOES_ON
        regs = space.model.t.regs
        if self.kept is None and int(regs[v.COUNT]) + self.coming > int(regs[v.MOST]):
            self._is_refused, self._end = True, -1
            return v.GOES_ON
        code = self._room_code()
        if code == v.GOES_ON:
            space.look_at_steps(self)
            code = self._commit()
            self._end = -1
        return code

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
        self._end = min(at + self._states, int(regs[v.LEVEL_END]))
        count = self._end - at
        regs[v.BATCH_FIRST] = at
        for n, worker in enumerate(self._workers):
            first, end = at + count * n // self._cores, at + count * (n + 1) // self._cores
            worker.take(self._space.model.t, first, end, self._room, at)

    def _gather(self) -> bool:
        """Gathers the steps of the batch; False if it has to begin anew."""
        space = self._space
        waiting = list(self._workers)
        while waiting:

            def gather(worker: Worker) -> int:
                return int(space.engine.explore_states(worker.tables, space.graph, self.batch, worker.end))

            codes = list(self._each(gather, waiting))
            waiting = [worker for worker, code in zip(waiting, codes, strict=True) if code != v.GOES_ON]
            for worker, code in zip(waiting, (code for code in codes if code != v.GOES_ON), strict=True):
                if code == v.ROOM_STEPS:
                    self._more_room()
                    return False
                if code == v.ROOM_AFTERS and worker.tables.regs[v.AFTERS]:
                    worker.forget_after()
                    continue
                space.complete_tables(int(worker.tables.regs[v.AT]))
                if space.model.layout is not self._layout:
                    return False
            for worker in waiting:
                worker.go_on(space.model.t)
        return True

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
        space, regs, batch = self._space, self._space.model.t.regs, self.batch
        engine, graph, two = space.engine, space.graph, space.model.layout.words == 2
        regions = [(worker.begin, int(worker.tables.regs[v.GATHERED])) for worker in self._workers]

        def insert(n: int) -> None:
            for first, end in regions:
                if self.kept is None:
                    low, high = _share(len(graph.slots), n, self._cores)
                    engine.insert_steps(graph, batch, first, end, low, high, two)
                else:
                    low, high = _share(len(self.kept.bits) // BLOCK, n, self._cores)
                    engine.filter_steps(self.kept, batch, first, end, low, high)

        list(self._each(insert, list(range(self._cores))))
        for worker in self._workers:
            self._note_kinds(worker.tables.regs)
            if self.kept is None:
                code = engine.number_steps(space.model.t, graph, batch, worker.end, worker.begin)
            else:
                code = engine.queue_steps(space.model.t, graph, batch, self.kept, worker.end, worker.begin)
            if code != v.GOES_ON:
                return int(code)
        return v.GOES_ON

    def _note_kinds(self, theirs: Any) -> None:
        """Takes over which states have the first events of their kinds."""
        regs = self._space.model.t.regs
        new = int(theirs[v.SEEN_KINDS]) & ~int(regs[v.SEEN_KINDS])
        for kind in range(v.KINDS):
            if new >> kind & 1:
                regs[v.FIRST_OF + kind] = theirs[v.FIRST_OF + kind]
        regs[v.SEEN_KINDS] |= new

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
    words = engine.words(0)
    return StepBatch(words, words, words, words, engine.zeros(0), engine.zeros(0), engine.bytes(0), words)
