"""The whole state of a run in tables of numbers: what the step works on, and all of it.

`State` names the tables. Under CPython they are lists (of lists, for tables of rows); `as_arrays` gives the same state
as NumPy arrays, for Numba, in which ragged rows are filled up with zeros. Nothing outside it decides how a run goes on:
`pack` writes what changes in a run as bytes, the same bytes for both forms, and `unpack` puts it back.

What the columns of tables mean is in `columns`; the tables of the world in `physics` and `docks`, of shared variables
in `sharing`, grids in `grids`.
"""

from __future__ import annotations

from array import array
from collections.abc import Iterator
from typing import Any, NamedTuple

from kitrobot.sim.columns import CONTACTS, EVENT, EVENTS, KEPT, MOVED

Reals = list[float]
Wholes = list[int]
RealRows = list[list[float]]
WholeRows = list[list[int]]


class State(NamedTuple):
    """The tables. Lists of whole numbers named `…s` after a thing hold its numbers: robots, actuators, docks."""

    fixed: Wholes
    fixed_real: Reals
    clock: Wholes
    events: Wholes
    # Robots; `solid` have wheels, `guided` are on roads (sorted along them), `free` are not, `carriers` have beds.
    real: RealRows
    whole: WholeRows
    solid: Wholes
    guided: Wholes
    free: Wholes
    free_solid: Wholes
    carriers: Wholes
    # Machines: by program, then by robot; the arrays of `tick`, room for one machine's, and a state that is kept.
    code: WholeRows
    commands: WholeRows
    parts: Wholes
    cells: WholeRows
    threads: WholeRows
    pars: WholeRows
    out: WholeRows
    seen: WholeRows
    was_cells: Wholes
    was_threads: Wholes
    was_pars: Wholes
    kept_cells: WholeRows
    kept_threads: WholeRows
    kept_pars: WholeRows
    # Devices; those of kind k are numbers bank[k] to bank[k + 1] - 1.
    sensor: WholeRows
    sensor_real: RealRows
    sensor_bank: Wholes
    past: Wholes
    actuator: WholeRows
    actuator_real: RealRows
    actuator_bank: Wholes
    wires: Wholes
    waited_for: Wholes
    late: Wholes
    takens: WholeRows
    faces: WholeRows
    queue: Wholes
    # Shared variables.
    shared: WholeRows
    apart: WholeRows
    mine_first: Wholes
    mine: Wholes
    mine_cell: Wholes
    copy_robot: Wholes
    copy_cell: Wholes
    # What befalls robots: the schedule, and the keys of chance.
    plan: WholeRows
    fate: WholeRows
    # The world.
    roads: WholeRows
    road_length: Reals
    points: RealRows
    cut_from: Reals
    cut_sign: Wholes
    docks: RealRows
    dock_road: Wholes
    stock: Wholes
    capacity: Wholes
    goals: WholeRows
    walls: RealRows
    wall_frame: Reals
    wall_shape: Wholes
    wall_starts: Wholes
    wall_items: Wholes
    stretches: RealRows
    colours: Wholes
    line_frame: Reals
    line_shape: Wholes
    line_starts: Wholes
    line_items: Wholes
    floors: WholeRows
    floor_box: RealRows
    floor_points: RealRows
    # Room to work in: the grid of robots, the cells of a ray, who touches whom.
    frame: Reals
    shape: Wholes
    starts: Wholes
    items: Wholes
    ray_cells: Wholes
    ray_exits: Reals
    pairs: Wholes
    before: Wholes
    buckets: Wholes
    chain: Wholes
    # Of a step that may change nothing: where and how fast robots were, and their devices' numbers (see standstill).
    held: RealRows


_REAL = frozenset(
    ("fixed_real", "real", "sensor_real", "actuator_real", "road_length", "points", "cut_from", "docks", "walls")
) | {"wall_frame", "stretches", "line_frame", "floor_box", "floor_points", "frame", "ray_exits", "held"}
_NARROW = frozenset(("cells", "threads", "pars", "out", "seen", "was_cells", "was_threads", "was_pars")) | {
    "kept_cells",
    "kept_threads",
    "kept_pars",
}
"""Tables of machines: 32 bits are enough for them, as on a board."""

_KEPT = ("kept_cells", "kept_threads", "kept_pars")
_ROWS = frozenset(name for name, kind in State.__annotations__.items() if "Rows" in str(kind))


def as_arrays(state: State) -> State:
    """The same state as arrays; needs NumPy."""
    import numpy as np

    widths = {name: max((len(row) for row in getattr(state, name[5:])), default=0) for name in _KEPT}
    widths |= {f"was_{name}": widths[f"kept_{name}"] for name in ("cells", "threads", "pars")}
    made: dict[str, Any] = {}
    for name, table in state._asdict().items():
        kind: Any = np.float64 if name in _REAL else np.int32 if name in _NARROW else np.int64
        if name == "code":
            kind = np.uint8
        if name not in _ROWS:
            filled = np.zeros(widths.get(name, len(table)), kind)
            filled[: len(table)] = table
        else:
            width = widths.get(name, max((len(row) for row in table), default=0))
            filled = np.zeros((len(table), width), kind)
            for number, row in enumerate(table):
                filled[number, : len(row)] = row
        made[name] = filled
    return State(**made)


def numbers(row: Any) -> list[Any]:
    """A row as a list of Python's own numbers, whatever it is."""
    return row if isinstance(row, list) else row.tolist()


def row_lengths(state: State) -> tuple[list[int], ...]:
    """The true lengths of each robot's rows of `cells`, `threads`, `pars`, `out` and `seen`, while they are lists."""
    tables = (state.cells, state.threads, state.pars, state.out, state.seen)
    return tuple([len(row) for row in table] for table in tables)


class Packing:
    """How a run's state becomes bytes; made while the state is in lists, for the true lengths of the rows."""

    def __init__(self, state: State) -> None:
        self._lengths = dict(zip(("cells", "threads", "pars", "out", "seen"), row_lengths(state), strict=True))
        self._takens = [len(row) for row in state.takens]
        self._faces = [(k, len(row)) for k, row in enumerate(state.faces) if row]

    def _tables(self, state: State, kept: bool, contacts: int, events: int) -> Iterator[tuple[str, Any, int]]:
        """(kind of number, row, how much of it) of all that changes in a run, the clock aside."""
        for wholes in (*state.whole, *state.sensor, *state.actuator, *state.shared, *state.apart):
            yield "q", wholes, len(wholes)
        for reals in (*state.real, *state.actuator_real):
            yield "d", reals, len(reals)
        for whole in (state.guided, state.past, state.queue, state.stock):
            yield "q", whole, len(whole)
        yield "q", state.before, 2 * contacts
        yield "q", state.events, EVENT * events
        for row, length in zip(state.takens, self._takens, strict=True):
            yield "q", row, length
        for k, length in self._faces:
            yield "q", state.faces[k], length
        for name, lengths in self._lengths.items():
            for row, length in zip(getattr(state, name), lengths, strict=True):
                yield "i", row, length
            if kept and name not in ("out", "seen"):
                for row, length in zip(getattr(state, f"kept_{name}"), lengths, strict=True):
                    # A program that had ended when the state was kept has none.
                    yield "i", row if len(row) else [0] * length, length

    def pack(self, state: State) -> bytes:
        """What changes in a run, as bytes."""
        clock = [int(number) for number in state.clock]
        clock[MOVED] = 1
        out = bytearray(array("q", clock).tobytes())
        for kind, row, length in self._tables(state, clock[KEPT] > 0, clock[CONTACTS], clock[EVENTS]):
            out += array(kind, numbers(row[:length])).tobytes()
        return bytes(out)

    def unpack(self, state: State, data: bytes) -> None:
        """Puts back what `pack` wrote.

        Raises:
            ValueError: the bytes are not of this run; then nothing was changed.
        """
        size = 8 * len(state.clock)
        clock = array("q", data[:size])
        if len(data) < size:
            raise ValueError("too short")
        kept, contacts, events = clock[KEPT] > 0, clock[CONTACTS], clock[EVENTS]
        if not (0 <= 2 * contacts <= len(state.before) and 0 <= EVENT * events <= len(state.events)):
            raise ValueError("counts beyond what there is room for")
        if kept:
            for name in _KEPT:
                for row, length in zip(getattr(state, name), self._lengths[name[5:]], strict=True):
                    if not len(row):
                        row[:] = [0] * length
        tables = list(self._tables(state, kept, contacts, events))
        sizes = {kind: array(kind).itemsize for kind in "qdi"}
        if size + sum(sizes[kind] * length for kind, _, length in tables) != len(data):
            raise ValueError("another size")
        state.clock[:] = clock.tolist()
        at = size
        for kind, row, length in tables:
            end = at + sizes[kind] * length
            row[:length] = array(kind, data[at:end]).tolist()
            at = end
