"""The state of a run as bytes: what changes in a run, the same bytes for lists and for arrays."""

from __future__ import annotations

from array import array
from collections.abc import Iterator
from typing import Any

from kitrobot.sim.tables.columns import CONTACTS, EVENT, EVENTS, KEPT, MOVED
from kitrobot.sim.tables.state import CHANGING, State, numbers
from kitrobot.text.sentences import Sentence


def row_lengths(state: State) -> tuple[list[int], ...]:
    """The true lengths of each robot's rows of `cells`, `threads`, `pars`, `out` and `seen`, while they are lists."""
    machines = state.machines
    tables = (machines.cells, machines.threads, machines.pars, machines.out, machines.seen)
    return tuple([len(row) for row in table] for table in tables)


class StateCodec:
    """How a run's state becomes bytes; made while the state is in lists, for the true lengths of the rows."""

    def __init__(self, state: State) -> None:
        self._lengths = dict(zip(("cells", "threads", "pars", "out", "seen"), row_lengths(state), strict=True))
        self._takens = [len(row) for row in state.actuators.takens]
        self._outputs = [(k, len(row)) for k, row in enumerate(state.actuators.outputs) if row]

    def _tables(self, state: State, kept: bool, contacts: int, events: int) -> Iterator[tuple[str, Any, int]]:
        """(kind of number, row, how much of it) of all that changes in a run, the clock aside."""
        robots, machines, actuators, shared = state.robots, state.machines, state.actuators, state.shared
        for row in (*robots.ints, *state.sensors.ints, *actuators.ints, *shared.ints, *shared.apart):
            yield "q", row, len(row)
        for column in (*robots.floats, *actuators.floats, *state.pens.rows, *state.pushables.floats[:4]):
            yield "d", column, len(column)
        for ints in (robots.guided, state.sensors.past, actuators.queue, state.docks.stock):
            yield "q", ints, len(ints)
        team = state.team
        for row in (team.numbers, team.emptied, team.kept_passes):
            yield "q", row, len(row)
        of_points = (team.points, team.robots, team.members, team.groups, team.vacated, team.since, team.kept)
        for table in (*of_points, team.works, team.holds, team.until, team.waits):
            for row in table:
                yield "q", row, len(row)
        for row in (*state.radio.robots, state.radio.due, *state.radio.air, state.radio.numbers):
            yield "q", row, len(row)
        yield "q", state.contacts.before, 2 * contacts
        yield "q", state.events, EVENT * events
        for row, length in zip(actuators.takens, self._takens, strict=True):
            yield "q", row, length
        for k, length in self._outputs:
            yield "q", actuators.outputs[k], length
        for name, lengths in self._lengths.items():
            for row, length in zip(getattr(machines, name), lengths, strict=True):
                yield "i", row, length
            if kept and name not in ("out", "seen"):
                for row, length in zip(getattr(machines, f"kept_{name}"), lengths, strict=True):
                    # A program that had ended when the state was kept has none.
                    yield "i", row if len(row) else [0] * length, length

    def encode(self, state: State) -> bytes:
        """What changes in a run, as bytes."""
        clock = [int(number) for number in state.clock]
        clock[MOVED] = 1
        out = bytearray(array("q", clock).tobytes())
        for kind, row, length in self._tables(state, clock[KEPT] > 0, clock[CONTACTS], clock[EVENTS]):
            out += array(kind, numbers(row[:length])).tobytes()
        return bytes(out)

    def decode(self, state: State, data: bytes) -> None:
        """Puts back what `pack` wrote.

        Raises:
            ValueError: the bytes are not of this run; then nothing was changed.
        """
        size = 8 * len(state.clock)
        clock = array("q", data[:size])
        if len(data) < size:
            raise ValueError(Sentence("too short"))
        kept, contacts, events = clock[KEPT] > 0, clock[CONTACTS], clock[EVENTS]
        if not (0 <= 2 * contacts <= len(state.contacts.before) and 0 <= EVENT * events <= len(state.events)):
            raise ValueError(Sentence("counts beyond what there is room for"))
        if kept:
            for name in CHANGING:
                for row, length in zip(getattr(state.machines, f"kept_{name}"), self._lengths[name], strict=True):
                    if not len(row):
                        row[:] = [0] * length
        tables = list(self._tables(state, kept, contacts, events))
        sizes = {kind: array(kind).itemsize for kind in "qdi"}
        if size + sum(sizes[kind] * length for kind, _, length in tables) != len(data):
            raise ValueError(Sentence("another size"))
        state.clock[:] = clock.tolist()
        at = size
        for kind, row, length in tables:
            end = at + sizes[kind] * length
            row[:length] = array(kind, data[at:end]).tolist()
            at = end
