"""The devices of one robot that no body has: `Team` and its works, answered by what the team agreed on.

Each of them does one thing at a time. What the program asks of it becomes a note for the log of the team, and is done
when the log, and what others did since, have ended it (see `sim.team.meetings`, `sim.team.work`).
"""

from __future__ import annotations

from dataclasses import dataclass, field

from kitrobot.fleet import notes
from kitrobot.fleet.replica import Replica
from kitrobot.sim.devices import sensors, team, team_answer, work, work_left
from kitrobot.sim.step.actuation import COMMAND
from kitrobot.sim.step.dispatch import AGREES
from kitrobot.sim.tables.columns import (
    A_CELL,
    A_KIND,
    A_ROBOT,
    ENDED,
    PROGRAM,
    S_CELL,
    S_LEAST,
    S_MOST,
    S_ROBOT,
    S_VALUE,
)
from kitrobot.sim.tables.team_columns import T_ACTUATOR, T_AT, T_ROLE

NoteRequest = tuple[int, int, int]
"""What is to be put into the log: the kind of the note, and its two numbers."""


@dataclass
class TeamDevices:
    """`Team` and the works of robot `me`, whose machine's cells and outputs are rows of the replica's tables.

    Attributes:
        waiting: of each actuator that waits for its note, its number in the tables → the serial of the note.
        joins: whether the last call of `Team` was one to wait for a role.
    """

    replica: Replica
    me: int
    waiting: dict[int, int] = field(default_factory=dict)
    joins: bool = False

    def __post_init__(self) -> None:
        state = self.replica.state
        ints = state.actuators.ints
        self.actuators = [
            k for k, robot in enumerate(ints[A_ROBOT]) if robot == self.me and AGREES[ints[A_KIND][k]] != 0
        ]
        self.banks = []
        for name, module in (("team", team_answer), ("work", work_left)):
            kind = sensors()[name].kind
            self.banks.append((module, state.sensors.bank[kind], state.sensors.bank[kind + 1]))

    def reset(self) -> None:
        """The program begins anew."""
        self.waiting.clear()
        self.joins = False

    def read(self) -> None:
        """Puts what the team answered, what is left of works, and what is done into the cells of the machine."""
        state = self.replica.state
        sensor, cells = state.sensors.ints, state.machines.cells[self.me]
        for module, first, last in self.banks:
            module.sense(first, last, 0, state)
            for k in range(first, last):
                if sensor[S_ROBOT][k] == self.me:
                    cells[sensor[S_CELL][k]] = min(max(sensor[S_VALUE][k], sensor[S_LEAST][k]), sensor[S_MOST][k])
        for k in self.actuators:
            cell = state.actuators.ints[A_CELL][k]
            if cell >= 0:
                cells[cell] = int(self.is_done(k))

    def is_done(self, k: int) -> bool:
        """Whether an actuator has ended its last command."""
        replica = self.replica
        if k in self.waiting:
            return False
        if not replica.is_of_team(self.me):
            return True
        tables = replica.state.team
        if k != tables.robots[T_ACTUATOR][self.me]:
            return k not in (row[self.me] for row in tables.waits)
        if self.joins:
            return tables.robots[T_ROLE][self.me] >= 0
        return tables.robots[T_AT][self.me] < 0

    def note_for(self, k: int, row: list[int]) -> NoteRequest | None:
        """What a command to one of these actuators asks of the log; `row` are its numbers as the machine gave them."""
        state = self.replica.state
        if not self.replica.is_of_team(self.me):
            return None
        procedure = state.machines.commands[state.robots.ints[PROGRAM][self.me]][COMMAND * row[2]]
        if k == state.team.robots[T_ACTUATOR][self.me]:
            self.joins = procedure == team.JOIN
            return None if self.joins else (notes.COME, row[3], row[4] if len(row) > 4 else 0)
        kind = notes.TAKE if procedure == work.TAKE else notes.DONE
        return kind, int(state.actuators.floats[work.WORK][k]), 0

    def has_ended(self) -> bool:
        """Whether the program of this robot is over, as the team knows it."""
        return bool(self.replica.state.robots.ints[ENDED][self.me])
