"""Approximate exploration: states are forgotten once their steps are known, and a Bloom filter says which were seen.

What a state takes is in `state_filter`: its share of the filter, and two bytes that say how it was reached. Keys are
kept only of states that wait for their turn, and of new ones until they were judged. A state that is taken for one that
was seen is omitted, with everything that only it leads to; so nothing can be said to hold.
"""

from __future__ import annotations

import random
import sys
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, field, replace
from typing import Any

from kitrobot.verifier.exploration import engines
from kitrobot.verifier.exploration.batch_search import BatchSearch
from kitrobot.verifier.exploration.budget import Budget
from kitrobot.verifier.exploration.engines import Engine
from kitrobot.verifier.exploration.exploration import (
    StateSpace,
    begin_exploration,
    continue_exploration,
    fresh_graph,
)
from kitrobot.verifier.exploration.memory import USUAL, resident
from kitrobot.verifier.exploration.state_filter import (
    BLOCK,
    MOST_BIRTHS,
    block_of,
    insert_hash,
    odds_of_omission,
)
from kitrobot.verifier.exploration.step_batches import layout_free_hash
from kitrobot.verifier.model.model import Model, State
from kitrobot.verifier.tables import columns as v
from kitrobot.verifier.tables.dynamic_arrays import grow_table
from kitrobot.verifier.tables.events import ModelTooLargeError
from kitrobot.verifier.tables.tables import StateFilter

MOST_STATES = 1 << 40
_SHARE = 0.5
"""The filter's share of the memory that is free; the rest is for what grows."""
_UNLIMITED = 512_000_000
"""Bytes of the filter where memory has no limit."""
_BYTES_EACH, _LEAST = 2, 1 << 20
"""Bytes of the filter for each state, where their number has a limit, and at least."""
_WINDOW = 1 << 20
"""Room for so many keys, with the compiled engine, before more is needed."""
_AT_ONCE = 65_536
"""States whose births are summed at once on the way back to a state."""


@dataclass
class ApproximateSpace(StateSpace):
    """What an approximate search keeps.

    Attributes:
        first: the first state.
        kept: the filter, and how each state was reached.
        judge: told that the states from one number on to before another are about to be forgotten.
        step_judge: told of each gathered batch of steps; None where steps are not judged.
        judged: the number of the first state that was not judged yet.
    """

    first: State = ()
    kept: StateFilter = field(default_factory=lambda: _new_filter(BLOCK))
    judge: Callable[[ApproximateSpace, int, int], None] = lambda space, first, end: None
    step_judge: Callable[[ApproximateSpace, BatchSearch], None] | None = None
    judged: int = 0

    @property
    def complete(self) -> bool:
        """Never: states may have been omitted."""
        return False

    @property
    def base(self) -> int:
        """The number of the first state whose key is kept."""
        return int(self.model.t.regs[v.BASE])

    @property
    def odds(self) -> float:
        """The odds that the next new state is taken for one that was seen; for earlier ones they were smaller."""
        return odds_of_omission(self.kept.bits)

    @property
    def memory(self) -> int:
        """Bytes of the filter, of how states were reached, of keys and of tables."""
        kept = len(self.kept.bits) + 2 * len(self) + 8 * (len(self.kept.wide) + len(self.graph.x) + len(self.graph.y))
        tables = sum(8 * len(table) for table in self.model.t) + 4 * len(self.graph.calm)
        return kept + tables + (0 if self.batches is None else self.batches.memory)

    def growth(self, code: int) -> int:
        """Bytes that the process takes, at least for a while, when `fill` is called with this code."""
        if code == v.ROOM_STATES:
            # One byte after another, and keys.
            return len(self) + 8 * (len(self) - self.expanded)
        return super().growth(code)

    def may_join(self, cores: int) -> None:
        """Lets so many cores explore, if the engine can use them: all from the beginning, since it goes in batches."""
        if self.batches is None:
            engine = self.engine
            self.batches = BatchSearch(
                self, cores if engine.is_parallel else 1, self.kept, lambda: engine.row(self._sums())
            )

    def look_at_steps(self, batches: BatchSearch) -> None:
        """Has the steps of a batch judged."""
        if self.step_judge is not None:
            self.step_judge(self, batches)

    def use(self, engine: Engine) -> None:
        """Switches to another engine, converting what is kept."""
        self.model.t, self.graph = engine.take(self.model.t, self.graph, _WINDOW)
        self.engine = engine
        births, picks = engine.bytes(len(self.kept.births)), engine.bytes(len(self.kept.picks))
        births[:], picks[:] = bytearray(self.kept.births), bytearray(self.kept.picks)
        numbers = [engine.row([int(one) for one in row]) for row in (self.kept.wide, self.kept.counts)]
        self.kept = StateFilter(engine.view(self.kept.bits), births, picks, *numbers)
        if self.batches is not None:
            self.batches.close()
            self.batches = None

    def fill(self, code: int) -> None:
        """Adds what a pause code asks for; room for states by forgetting those whose steps are known."""
        if code != v.ROOM_STATES:
            super().fill(code)
            return
        assert self.batches is not None, "it asked for room"
        self.judge_new()
        done, left, coming = self.expanded - self.base, len(self) - self.expanded, self.batches.coming
        for keys in (self.graph.x, self.graph.y):
            if len(keys):
                keys[:left] = keys[done : done + left]
        self.model.t.regs[v.BASE] += done
        while 2 * left + coming > len(self.graph.x):
            self._grow("x", *(("y",) if self.model.layout.words == 2 else ()))
        most = len(self) + coming
        for name, needed in (("births", most), ("picks", most), ("wide", int(self.kept.counts[0]) + 2 * coming)):
            row = getattr(self.kept, name)
            if needed > len(row):
                grown = grow_table(row, max(needed, len(row) + len(row) // 2))
                self.kept = self.kept._replace(**{name: grown})
        self.batches.kept = self.kept

    def judge_new(self) -> None:
        """Has the states judged that were not yet."""
        first, self.judged = self.judged, len(self)
        self.judge(self, first, self.judged)
        self.model.t.regs[v.CALMS] = 0

    def way(self, number: int) -> list[State]:
        """The states on the way by which a state was reached whose key is still kept, from the first one on."""
        picks, at, end, born = [], number, self.expanded, len(self) - 1
        wide = {int(self.kept.wide[n]): int(self.kept.wide[n + 1]) for n in range(0, int(self.kept.counts[0]), 2)}
        while at > 0:
            # So many states were born, besides the first one, of those before `end`.
            while born >= at:
                begin = max(0, end - _AT_ONCE)
                some = self._births(begin, end, wide)
                while born - some < at and end - begin > 1:
                    begin = (begin + end) // 2
                    some = self._births(begin, end, wide)
                end, born = begin, born - some
            picks.append(int(self.kept.picks[at]))
            at = end
        return self._walk(picks[::-1], self.state(number))

    def _births(self, begin: int, end: int, wide: dict[int, int]) -> int:
        """How many states were reached first from the states from `begin` to before `end`."""
        found = sum(bytes(self.kept.births[begin:end]))
        return found + sum(count - MOST_BIRTHS for state, count in wide.items() if begin <= state < end)

    def _walk(self, picks: list[int], goal: State) -> list[State]:
        """The states after steps with these places, modulo 256: the first such way that ends at a state."""
        steps = [iter([self.first])]
        found: list[State] = []
        while steps:
            state = next(steps[-1], None)
            if state is None:
                steps.pop()
                if found:
                    found.pop()
                continue
            found.append(state)
            depth = len(found) - 1
            if depth == len(picks):
                if state == goal:
                    return found
                found.pop()
                continue
            after = [one for one, _, _ in self.steps_from(state)]
            steps.append(iter(after[picks[depth] :: 256]))
        raise AssertionError("the way of a state leads to it")

    def _rebuild_slots(self, size: int) -> None:
        """Nothing: the filter stays as it is when keys are rewritten."""

    def _sums(self) -> list[int]:
        """The words of `StepBatch.sums`: of each bit of each field a random one, wherever the field is in the key."""
        layout, bits = self.model.layout, [0] * 128
        for f, (word, shift, mask) in enumerate(zip(layout.word, layout.shift, layout.mask, strict=True)):
            chance = random.Random(f)
            for bit in range(mask.bit_length()):
                bits[64 * word + shift + bit] = chance.getrandbits(v.WORD_BITS)
        sums = [0] * (16 * 256)
        for at in range(len(sums)):
            byte = at % 256
            if byte:
                low = byte & -byte
                sums[at] = sums[at ^ low] ^ bits[at // 256 * 8 + low.bit_length() - 1]
        return sums


def explore_approximately(
    model: Model,
    budget: Budget,
    judge: Callable[[ApproximateSpace, int, int], None],
    step_judge: Callable[[ApproximateSpace, BatchSearch], None] | None = None,
    engine: Engine | None = None,
) -> ApproximateSpace:
    """Explores the states of a model without keeping them.

    Args:
        model: a model that has not been explored.
        budget: the limits; what memory is left of the limit decides the size of the filter.
        judge: called with the space and the numbers of the first state, and of the one behind the last, of those that
            are about to be forgotten; `way` and `state` know each of them then. Every reached state is judged once.
        step_judge: called with the space and each gathered batch of steps; None where steps need not be judged.
        engine: the engine; None for the plain one until the compiled one is available and worth it.
    """
    began = budget.clock()
    budget = replace(budget, alone=0)
    space = ApproximateSpace(
        *(model, fresh_graph(), engines.PLAIN),
        interruption=budget.interruption(began),
        kept=_new_filter(_filter_bytes(budget)),
        judge=judge,
        step_judge=step_judge,
    )
    with suppress(ModelTooLargeError):
        begin_exploration(space, MOST_STATES if budget.states is None else budget.states, False)
        space.first = space.state(0)
        h = layout_free_hash(space._sums(), *model.layout.key(space.first), model.layout.words == 2)
        insert_hash(space.kept.bits, block_of(h, len(space.kept.bits) // BLOCK), h)
        if engine is not None:
            space.use(engine)
        space.cut = continue_exploration(space, budget, engine is None)
    space.judge_new()
    if space.batches is not None:
        space.batches.close()
    space.seconds = budget.clock() - began
    budget.progress(len(space), space.depth)
    return space


def _filter_bytes(budget: Budget) -> int:
    """The bytes of the filter: whole blocks, at least one."""
    room = _UNLIMITED
    if budget.memory is not None:
        room = int(_SHARE * max(0, budget.memory - (resident() or USUAL)))
    if budget.states is not None:
        room = min(room, max(_LEAST, _BYTES_EACH * budget.states))
    return max(1, room // BLOCK) * BLOCK


def _new_filter(size: int) -> StateFilter:
    """An empty filter of so many bytes; the system gives memory to what is used of it."""
    bits: Any
    try:
        import mmap

        if sys.platform == "linux":
            bits = mmap.mmap(-1, size, mmap.MAP_PRIVATE | mmap.MAP_ANONYMOUS)
            # Nearly every read is of another page: with large ones the processor knows where it is.
            with suppress(OSError):
                bits.madvise(mmap.MADV_HUGEPAGE)
        else:
            bits = mmap.mmap(-1, size)
        bits = memoryview(bits)
    except (ImportError, OSError, ValueError):
        bits = bytearray(size)
    return StateFilter(bits, bytearray(4096), bytearray(4096), [0] * 1024, [0])
