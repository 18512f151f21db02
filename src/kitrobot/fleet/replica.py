"""`Replica`: the agreed state of a team, computed from its log with the simulator's functions, so both agree.

It works on the tables of a run (`sim.tables.state.State`), of which it changes those of the team: points, sets, roles,
works. Equal logs make equal tables, in every process: nothing here reads a clock or anything else of the process.
`slot` is how many slots of the log are in them. A robot in no view of the log is silent, as a failed one is in the
simulator.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from kitrobot.fleet import notes
from kitrobot.sim.event_text import Event
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.step.program_ends import end_program
from kitrobot.sim.step.substitution import declare_missing, finish_team_step, handle_return
from kitrobot.sim.tables.columns import ACTUATOR_INDEX, ENDED, EVENTS
from kitrobot.sim.tables.state import State
from kitrobot.sim.tables.team_columns import (
    HAS_UNIT,
    LOST_UNIT,
    T_ACTUATOR,
    T_AT,
    T_ROLE,
    T_SILENT,
    TEAM_OVER,
    W_LEFT,
    W_TAKEN,
)
from kitrobot.sim.team.meetings import arrive, find_members
from kitrobot.sim.team.work import finish_unit, take_unit
from kitrobot.team.changes import AppliedNote, NewView
from kitrobot.team.commands import Seat

Effect = AppliedNote | NewView
"""What a slot of the log does to a replica."""

MOST_NUMBER = 1 << 40
"""Numbers beyond this are in no table."""


class Replica:
    """The team's part of a run, after the first `slot` slots of its log.

    Args:
        simulation: the run whose tables it changes; it must not have been stepped.

    Attributes:
        epochs: for each robot, how often it left the team or came to it.
        lives: for each robot, its life in the view; -1: it is not in it.
        beginnings: for each robot, how often its program was begun anew.
        grants: for each work and robot, how often the robot was given a unit.
    """

    def __init__(self, simulation: Simulation) -> None:
        self.simulation = simulation
        self.slot = 0
        count = len(simulation.members)
        self.epochs = [0] * count
        self.lives = [0] * count
        self.beginnings = [0] * count
        self.grants = [[0] * count for _ in simulation.state.team.holds]

    @property
    def state(self) -> State:
        """The tables."""
        return self.simulation.state

    @property
    def has_team(self) -> bool:
        """Whether a team's program is run at all."""
        return bool(self.state.team.set_first)

    def is_of_team(self, robot: int) -> bool:
        """Whether a robot runs the team's program."""
        return self.has_team and self.state.team.robots[T_ACTUATOR][robot] >= 0

    def link(self, robot: int, actuator: int) -> int:
        """The number in the tables of an actuator of a robot, as its XML counts them."""
        return self.state.actuators.actuator_index[self.state.robots.ints[ACTUATOR_INDEX][robot] + actuator]

    # -- the log

    def apply(self, slot: int, effects: Iterable[Effect]) -> list[Event]:
        """Takes in slot number `slot`, which must be the next one; returns its events."""
        assert slot == self.slot, "slots are taken in one after the other"
        before = self.state.clock[EVENTS]
        for effect in effects:
            held = [list(row) for row in self.state.team.holds]
            if isinstance(effect, NewView):
                self._apply_view(effect.view.seats)
            else:
                self._apply_note(effect.seat, effect.numbers)
            if self.has_team:
                finish_team_step(self.state)
                self._count_grants(held)
        self.slot = slot + 1
        return self._take_events(before)

    def _take_events(self, before: int) -> list[Event]:
        """The events since there were so many; they are taken out of the tables."""
        state = self.state
        events = self.simulation.happened()[before:]
        state.clock[EVENTS] = before
        return events

    def _count_grants(self, held: Sequence[Sequence[int]]) -> None:
        for work, row in enumerate(self.state.team.holds):
            for robot, now in enumerate(row):
                if now == HAS_UNIT and held[work][robot] != HAS_UNIT:
                    self.grants[work][robot] += 1

    def _apply_view(self, seats: Sequence[Seat]) -> None:
        """Robots that left the view are missed; those that are new in it begin anew, unless nobody missed them."""
        lives = [-1] * len(self.lives)
        for seat in seats:
            if 0 <= seat.member < len(lives):
                lives[seat.member] = seat.life
        gone = [i for i, life in enumerate(self.lives) if life >= 0 and lives[i] != life]
        returned = [i for i, life in enumerate(lives) if life >= 0 and self.lives[i] != life]
        self.lives = lives
        team = self.state.team
        for i in gone:
            self.epochs[i] += 1
            if self.is_of_team(i):
                team.robots[T_SILENT][i] = 0
        for i in gone:
            if self.is_of_team(i) and team.robots[T_ROLE][i] >= 0 and not self.state.robots.ints[ENDED][i]:
                declare_missing(i, self.state)
        for i in returned:
            self.epochs[i] += 1
            if self.is_of_team(i):
                self.beginnings[i] += handle_return(i, self.state)

    def _apply_note(self, seat: Seat, numbers: tuple[int, ...]) -> None:
        """Applies a robot's note; one that it may not send, or that it sent before it was missed, has no effect."""
        note = notes.decode_note(numbers)
        i = seat.member
        if note is None or not 0 <= i < len(self.epochs):
            return
        state, team = self.state, self.state.team
        if note.kind == notes.FREE:
            self._free(note)
            return
        if note.epoch != self.epochs[i] or state.robots.ints[ENDED][i]:
            return
        if note.kind == notes.END:
            end_program(i, state)
            return
        if not self.is_of_team(i):
            return
        if note.kind == notes.COME:
            free = team.robots[T_ROLE][i] >= 0 and team.robots[T_AT][i] < 0
            if free and 0 <= note.first < len(team.points[0]) and abs(note.second) < MOST_NUMBER:
                arrive(i, note.first, note.second, state)
        elif 0 <= note.first < len(team.holds):
            if note.kind == notes.DONE:
                finish_unit(i, note.first, state)
            elif team.waits[note.first][i] < 0:
                take_unit(i, note.first, self.work_link(i, note.first), state)

    def _free(self, note: notes.ReplicatedNote) -> None:
        """A unit whose lease is over is free again, if it is that very one; the epoch names the grant."""
        team = self.state.team
        work, robot = note.first, note.second
        if not (0 <= work < len(team.holds) and 0 <= robot < len(self.epochs)):
            return
        if team.holds[work][robot] == HAS_UNIT and self.grants[work][robot] == note.epoch:
            team.holds[work][robot] = LOST_UNIT
            team.works[W_TAKEN][work] -= 1

    def work_link(self, robot: int, work: int) -> int:
        """The number of a robot's actuator for a work of its team."""
        name = self.simulation.mission.team.works[work].name
        parts = self.simulation.members[robot].robot.actuators
        return self.link(robot, next(n for n, part in enumerate(parts) if part.name == name))

    # -- looking

    def is_over(self) -> bool:
        """Whether the team cannot go on."""
        return bool(self.state.team.numbers[TEAM_OVER])

    def held_units(self) -> list[tuple[int, int, int]]:
        """Work, robot and grant of each unit that somebody has."""
        return [
            (work, robot, self.grants[work][robot])
            for work, row in enumerate(self.state.team.holds)
            for robot, now in enumerate(row)
            if now == HAS_UNIT
        ]

    def units_done(self) -> dict[str, int]:
        """Of each work, how many units are done."""
        left = self.state.team.works[W_LEFT]
        works = self.simulation.mission.team.works
        return {work.name: work.units - left[n] for n, work in enumerate(works) if n < len(left)}

    # -- for who was away too long to be told each slot

    def packed(self) -> list[list[int]]:
        """Everything that the log has made of the tables, as rows of numbers."""
        return [list(map(int, row)) for row in self._rows()]

    def unpack(self, slot: int, rows: Sequence[Sequence[int]]) -> bool:
        """Takes over the tables after so many slots; False, and nothing is changed, if they are of another team."""
        mine = self._rows()
        if slot < self.slot or len(rows) != len(mine):
            return False
        if any(len(row) != len(own) for row, own in zip(rows, mine, strict=True)):
            return False
        before = list(self.state.robots.ints[ENDED])
        for own, row in zip(mine, rows, strict=True):
            own[:] = row
        ended = self.state.robots.ints[ENDED]
        for i, was in enumerate(before):
            if ended[i] and not was:
                ended[i] = 0
                count = self.state.clock[EVENTS]
                end_program(i, self.state)
                self._take_events(count)
        self.slot = slot
        if self.has_team:
            find_members(self.state.team)
        return True

    def _rows(self) -> list[list[int]]:
        team = self.state.team
        tables = (team.points, team.robots, team.groups, team.vacated, team.since, team.works, team.holds, team.waits)
        rows = [row for table in (*tables, self.grants) for row in table]
        return [
            team.numbers,
            team.emptied,
            self.epochs,
            self.lives,
            self.beginnings,
            self.state.robots.ints[ENDED],
            *rows,
        ]
