"""`TickRunner`: runs the ticks of one agent's machine; writes its cells before a tick and reads its results after."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from kitrobot.fleet.body_messages import Frame
from kitrobot.fleet.recurrence import Recurrence, Snapshot
from kitrobot.fleet.replication import LogReplication
from kitrobot.fleet.team_devices import NoteRequest, TeamDevices
from kitrobot.sim.host_step import TickResult
from kitrobot.sim.step.actuation import COMMAND
from kitrobot.sim.tables.columns import A_CELL, ACTUATOR_INDEX, PROGRAM, S_CELL, S_ROBOT
from kitrobot.sim.team.shared_variables import SHARED_VALUE

Rows = tuple[tuple[int, ...], ...]
"""Commands as rows of the machine's output, each with the number of its actuator before it."""
Writes = tuple[tuple[int, int], ...]
"""Shared variables and what was written into them."""


@dataclass(slots=True)
class Tick:
    """A tick that was begun for a frame.

    Attributes:
        epoch, beginning: those of the robot then; commands of an earlier epoch are void.
        at: when it was begun, ms.
        before: the machine before it.
        result: what came of it: for the tables of the world, the shared variables that it wrote, whether it changed
            nothing; None where nothing came of it.
        over: whether it was made.
        late: whether its frame was answered before it was.
    """

    frame: Frame
    epoch: int
    beginning: int
    at: int
    before: Snapshot
    result: tuple[TickResult, Writes, bool] | None = None
    over: bool = False
    late: bool = False


class TickRunner:
    """The machine of robot `devices.me`.

    Attributes:
        shared: its shared variables, each with its cell.
    """

    def __init__(self, devices: TeamDevices, replication: LogReplication) -> None:
        self._devices = devices
        self._replica = devices.replica
        self._me = devices.me
        self.machine = self._replica.simulation.members[self._me].machine
        self.shared = replication.shared_cells(self._me)
        self._given: dict[int, int] = {}
        """For each cell that shows whether a command is done, the frame of the last such command."""
        state = self._replica.state
        ints = state.sensors.ints
        self._own_cells = {
            ints[S_CELL][k]
            for _, first, last in devices.banks
            for k in range(first, last)
            if ints[S_ROBOT][k] == self._me
        } | {state.actuators.ints[A_CELL][k] for k in devices.actuators}
        self._first = self.machine.snapshot()
        self._recurrence = Recurrence()

    def restart(self) -> None:
        """The program begins anew."""
        self.machine.restore(self._first)
        self._devices.reset()

    def is_over(self) -> bool:
        """Whether the program is at its end."""
        return self.machine.ended or self._devices.has_ended()

    def sense(self, frame: Frame | None, values: Mapping[int, int]) -> None:
        """Puts what is known before a tick into the cells: readings, what the team answered, shared variables.

        Args:
            frame: the readings of a simulated body; None where a board measures by itself.
            values: shared variables that were written, and what they are.
        """
        cells = self.machine.cells
        if frame is not None:
            for cell, value in enumerate(frame.inputs[: self.machine.layout.inputs], 1):
                if cell not in self._own_cells:
                    cells[cell] = 0 if self._given.get(cell, 0) > frame.taken else value
        self._devices.read()
        known = self._replica.state.shared.ints[SHARED_VALUE]
        for variable, value in values.items():
            known[variable] = value
        for variable, cell in self.shared:
            cells[cell] = known[variable]

    def team_inputs(self) -> dict[int, int]:
        """The inputs that no body has, and what they are."""
        return {cell: self.machine.cells[cell] for cell in self._own_cells}

    def commands(self, serial: int) -> tuple[Rows, list[tuple[int, NoteRequest]]]:
        """The commands of the tick for a frame; of those to the team, what is to be put into the log, for which
        actuator.
        """
        machine, state = self.machine, self._replica.state
        first = state.robots.ints[ACTUATOR_INDEX][self._me]
        given, requests = [], []
        for number in range(machine.image.actuators):
            row = list(machine.out[number * machine.width : (number + 1) * machine.width])
            if not row[0]:
                continue
            given.append((number, *row))
            k = state.actuators.actuator_index[first + number]
            if state.machines.commands[state.robots.ints[PROGRAM][self._me]][COMMAND * row[2] + 2]:
                self._given[state.actuators.ints[A_CELL][k]] = serial
            if k in self._devices.actuators:
                request = self._devices.note_for(k, row)
                if request is not None:
                    requests.append((k, request))
        return tuple(given), requests

    def changed_variables(self) -> Writes:
        """The shared variables that the tick has changed."""
        values = self._replica.state.shared.ints[SHARED_VALUE]
        written = [(v, self.machine.cells[cell]) for v, cell in self.shared if self.machine.cells[cell] != values[v]]
        for variable, value in written:
            values[variable] = value
        return tuple(written)

    def result_of(self, out: Rows, writes: Writes, tick: Tick) -> tuple[TickResult, bool]:
        """What came of a tick for the tables of the world, and whether it changed nothing, or only goes round."""
        machine = self.machine
        cells, threads = machine.cells[: machine.layout.cells], machine.threads[: 2 * len(machine.image.slots)]
        made = TickResult(tuple(cells), tuple(threads), out)
        if out or writes:
            self._recurrence.reset()
            return made, False
        after = machine.snapshot()
        return made, self._recurrence.repeats(after) or after == tick.before
