"""Engines that explore and search states: the same functions, run by CPython or compiled by Numba.

The functions are those of `breadth_first_search`, `step_batches`, `state_filter`, `state_marks` and `fairness`. Both
engines run one source and give the same numbers in the same order, so an exploration may switch from one to the other.
"""

from __future__ import annotations

from array import array
from collections.abc import Callable
from functools import cached_property
from typing import Any, NamedTuple

from kitrobot.sim.jit.table_pointer import TablePointer
from kitrobot.verifier.exploration import breadth_first_search as bfs
from kitrobot.verifier.exploration import fairness, state_filter, state_marks, step_batches
from kitrobot.verifier.tables.tables import Graph, StateFilter, StepBatch, Tables


class Engine(NamedTuple):
    """The functions of one engine.

    Attributes:
        explore_states, insert_steps, number_steps: of `step_batches`.
        filter_steps, queue_steps: of `state_filter`.
        expand, rehash, repack: of `breadth_first_search`.
        mark, observe, crossing, prune: of `state_marks`.
        search, reach, sample, way: of `fairness`.
        row: converts a list of numbers to the type that the functions take.
        zeros, bytes, words: make arrays of so many zeros, of 32, 8 or 64 bits.
        view: makes of a memory of bytes what the functions take, without a copy.
        take: converts tables and graph to the types that the functions take, with room for so many states.
        is_parallel: whether the functions run on several cores beside each other.
    """

    explore_states: Callable[..., int]
    insert_steps: Callable[..., int]
    number_steps: Callable[..., int]
    filter_steps: Callable[..., int]
    queue_steps: Callable[..., int]
    expand: Callable[..., int]
    rehash: Callable[..., None]
    repack: Callable[..., None]
    mark_states: Callable[..., int]
    sense_agent: Callable[..., int]
    find_crossing: Callable[..., int]
    prune_open_states: Callable[..., int]
    find_fair_component: Callable[..., int]
    mark_reachable: Callable[..., int]
    sample_steps: Callable[..., None]
    find_shortest_path: Callable[..., int]
    row: Callable[[list[int]], Any]
    zeros: Callable[[int], Any]
    bytes: Callable[[int], Any]
    words: Callable[[int], Any]
    view: Callable[[Any], Any]
    take: Callable[[Tables, Graph, int], tuple[Tables, Graph]]
    is_parallel: bool = False


FUNCTIONS: dict[str, Any] = {
    "explore_states": step_batches.explore_states,
    "insert_steps": step_batches.insert_steps,
    "number_steps": step_batches.number_steps,
    "filter_steps": state_filter.filter_steps,
    "queue_steps": state_filter.queue_steps,
    "expand": bfs.expand,
    "rehash": bfs.rehash,
    "repack": bfs.repack,
    "mark_states": state_marks.mark_states,
    "sense_agent": state_marks.sense_agent,
    "find_crossing": state_marks.find_crossing,
    "prune_open_states": state_marks.prune_open_states,
    "find_fair_component": fairness.find_fair_component,
    "mark_reachable": fairness.mark_reachable,
    "sample_steps": fairness.sample_steps,
    "find_shortest_path": fairness.find_shortest_path,
}
"""The functions called from Python, by name."""


def _as_lists(tables: Tables, graph: Graph, most: int) -> tuple[Tables, Graph]:
    lists = [[int(one) for one in table] for table in tables]
    kinds = {"x": "q", "y": "q", "taken": "H"}
    return Tables(*lists), Graph(
        *(array(kinds.get(name, "i"), [int(one) for one in getattr(graph, name)]) for name in Graph._fields)
    )


PLAIN = Engine(
    **FUNCTIONS,
    row=list,
    zeros=lambda size: array("i", bytes(4 * size)),
    bytes=bytearray,
    words=lambda size: array("q", bytes(8 * size)),
    view=memoryview,
    take=_as_lists,
)


class ArrayTables(Tables):
    """Tables that are arrays."""

    @cached_property
    def pointer(self) -> TablePointer:
        """The pointer passed to compiled code.

        It does not refer back to this value: a cycle would keep all arrays alive until the garbage collector runs.
        """
        return TablePointer(Tables(*self))


class ArrayGraph(Graph):
    """A graph whose tables are arrays."""

    @cached_property
    def pointer(self) -> TablePointer:
        """The pointer passed to compiled code; see `ArrayTables`."""
        return TablePointer(Graph(*self))


def _to_argument(argument: Any) -> Any:
    """Converts an argument to the type that compiled code takes."""
    if isinstance(argument, fairness.ComponentSearch | StepBatch | StateFilter):
        return TablePointer(argument)
    return argument.pointer if isinstance(argument, ArrayTables | ArrayGraph) else argument


def _with_pointers(function: Callable[..., Any]) -> Callable[..., Any]:
    return lambda *arguments: function(*map(_to_argument, arguments))


def array_engine(functions: dict[str, Callable[..., Any]]) -> Engine:
    """An engine of compiled functions, which take pointers to arrays."""
    import numpy as np

    def take(tables: Tables, graph: Graph, most: int) -> tuple[Tables, Graph]:
        kinds: dict[str, Any] = {"x": np.int64, "y": np.int64, "taken": np.uint16}
        made: list[Any] = []
        for name in Graph._fields:
            table = getattr(graph, name)
            size = len(table)
            if name in ("x", "parents", "first_edge") or (name == "y" and size):
                size = max(size, most + 2)
            elif name in ("targets", "taken"):
                size = max(size, 4 * most)
            filled: Any = (np.zeros if name == "slots" else np.empty)(size, kinds.get(name, np.int32))
            filled[: len(table)] = table
            made.append(filled)
        rows: list[Any] = [np.array(table, np.int64) for table in tables]
        return ArrayTables(*rows), ArrayGraph(*made)

    return Engine(
        **{name: _with_pointers(function) for name, function in functions.items()},
        row=lambda numbers: np.array(numbers, np.int64),
        zeros=lambda size: np.zeros(size, np.int32),
        bytes=lambda size: np.zeros(size, np.uint8),
        words=lambda size: np.zeros(size, np.int64),
        view=lambda memory: np.frombuffer(memory, np.uint8),
        take=take,
        is_parallel=True,
    )
