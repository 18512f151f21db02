"""The state of a team as part of a model's shared state: waiting robots, answers, groups, and units of work.

The simulator itself (`sim.team.meetings`, `sim.team.work`) executes commands to `Team` and to works, on a private copy
of its tables: the state is written into the tables before a command and read back after it. This module assumes that
no robot fails, so a robot that plays no role never plays one; `absence` adds missed robots and substitutes.
"""

from __future__ import annotations

import copy
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import NamedTuple

from kitrobot.sim.devices.base import Command
from kitrobot.sim.setup.radio_tables import no_radio
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.step.dispatch import start
from kitrobot.sim.tables import columns as c
from kitrobot.sim.tables import team_columns as tc
from kitrobot.sim.tables.state import State, Team, numbers
from kitrobot.sim.team.meetings import agree, find_members
from kitrobot.sim.team.work import is_taken, share_out

TeamState = tuple[int, ...]
"""A state of a team: each robot's waiting point, argument and answer; passes; groups; works."""


class TeamCommand(NamedTuple):
    """A command to the team or a work: the actuator by its number in the run, the procedure and its arguments."""

    actuator: int
    procedure: int
    first: int
    second: int


class Agreement:
    """The team of a run that is before its first step.

    Args:
        run: the run.
        actuators: those that take part in team agreement, by their numbers in the run.
    """

    def __init__(self, run: Simulation, actuators: Sequence[int]) -> None:
        self.actuators = tuple(actuators)
        self._state = self._copy_state(run.state)
        self._team = self._state.team
        self._rows = self._own_rows()
        self._sizes = [len(row) for row in self._rows]
        self.first = self._read()
        """The state before the first step."""

    def _copy_state(self, state: State) -> State:
        """Copies everything of a state that team commands change."""
        ints = [list(numbers(row)) for row in state.actuators.ints]
        return replace(
            state,
            clock=[0] * len(state.clock),
            events=[0] * len(state.events),
            actuators=replace(state.actuators, ints=ints),
            radio=no_radio(),
            team=copy.deepcopy(state.team),
        )

    def is_member(self, robot: int) -> bool:
        """Whether a robot, by its number in the run, is of the team."""
        return self._team.robots[tc.T_ACTUATOR][robot] >= 0

    def plays(self, robot: int) -> bool:
        """Whether it plays a role at first."""
        return self._team.robots[tc.T_ROLE][robot] >= 0

    def answer(self, robot: int) -> int:
        """The place in a team's state of a robot's last answer."""
        return self._place(2) + robot

    def left(self, work: int) -> int:
        """The place in a state of how many units of a work are not done; -1 where there is no such work."""
        return self._place(4) + work if work < self._sizes[4] else -1

    def tables(self, agreed: TeamState) -> Team:
        """The tables of the team in a state; valid until the next call."""
        self._write(agreed)
        return self._team

    def waits(self, robot: int) -> int:
        """The place in a state of the point at which a robot waits; less than 0 there for none."""
        return robot

    @property
    def has_meetings(self) -> bool:
        """Whether there is a point of the team's program at which robots wait for others."""
        return any(kind > tc.BRANCH for kind in self._team.points[tc.P_KIND])

    def units(self, robot: int) -> list[int]:
        """The places in a state of whether a robot has a unit (`HAS_UNIT`) of each work whose units stay with it."""
        first = self._place(5 + len(self._team.groups))
        leases, robots = self._team.works[tc.W_LEASE], len(self._team.robots[tc.T_AT])
        return [
            first + work * robots + robot for work, lease in enumerate(leases[: len(self._team.holds)]) if not lease
        ]

    def done(self, actuator: int) -> int:
        """The place in a team's state of whether an actuator has completed its command."""
        return self._place(len(self._rows)) + self.actuators.index(actuator)

    def after(self, agreed: TeamState, told: Sequence[TeamCommand]) -> TeamState:
        """The state after commands, before any agreement."""
        self._write(agreed)
        for one in told:
            command = Command(one.procedure, 2, one.first, one.second, one.second)
            start(one.actuator, command, 0.0, self._state)
        return self._read()

    def settled(self, agreed: TeamState) -> TeamState:
        """The state after one step in which all robots continue that need not wait any longer."""
        self._write(agreed)
        agree(self._state)
        if len(self._team.holds) > 0:
            share_out(self._state)
        return self._read()

    def all_settled(self, agreed: TeamState) -> TeamState:
        """The state after such steps until nothing changes."""
        while True:
            after = self.settled(agreed)
            if after == agreed:
                return after
            agreed = after

    def _place(self, row: int) -> int:
        return sum(self._sizes[:row])

    def _own_rows(self) -> list[list[int]]:
        """The rows that change; `answer` is the third and `left` the fifth."""
        team = self._team
        return [
            team.robots[tc.T_AT],
            team.robots[tc.T_GIVEN],
            team.robots[tc.T_ANSWER],
            team.points[tc.P_PASSES],
            team.works[tc.W_LEFT],
            *team.groups,
            *team.holds,
            *team.waits,
        ]

    def _read(self) -> TeamState:
        at, given = self._rows[0], self._rows[1]
        # What somebody gave counts only while it waits.
        for i in range(len(at)):
            if at[i] < 0:
                given[i] = 0
        done = self._state.actuators.ints[c.A_DONE]
        agreed = (*(one for row in self._rows for one in row), *(done[k] for k in self.actuators))
        return agreed + self._read_robots()

    def _read_robots(self) -> TeamState:
        """The rest of a state: the fate of robots that fail."""
        return ()

    def _write(self, agreed: TeamState) -> None:
        """Puts a state into the tables, and what follows from it."""
        state, team = self._state, self._team
        values: Iterator[int] = iter(agreed)
        for row in self._rows:
            for n in range(len(row)):
                row[n] = next(values)
        for k in self.actuators:
            state.actuators.ints[c.A_DONE][k] = next(values)
        self._write_robots(values)
        state.clock[c.EVENTS] = 0
        waiting, at = team.points[tc.P_WAITING], team.robots[tc.T_AT]
        for p in range(len(waiting)):
            waiting[p] = sum(point == p for point in at)
        for w in range(len(team.holds)):
            team.works[tc.W_TAKEN][w] = sum(map(is_taken, team.holds[w]))
            team.works[tc.W_WAITING][w] = sum(one >= 0 for one in team.waits[w])
        find_members(team)

    def _write_robots(self, values: Iterator[int]) -> None:
        """Puts the rest of a state into the tables. What leads substitutes is forgotten: nobody needs any."""
        robots, ended = self._team.robots, self._team.points[tc.P_ENDED]
        ended[:] = [0] * len(ended)
        for i in range(len(robots[tc.T_AT])):
            robots[tc.T_SINCE][i], robots[tc.T_ANCHOR][i], robots[tc.T_BRANCH][i] = 0, -1, -1
