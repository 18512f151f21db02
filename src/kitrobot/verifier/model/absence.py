"""Team members that fail, stall or lose their radio, as part of the team's state (`team_agreement`).

A *silent* member is missed at some time, or heard again before that; the lease of a unit of work ends at some time. In
the simulator both take a certain time, in the model any time. The simulator itself (`sim.step.substitution`,
`sim.team.work`) applies the rules of the groups, on a copy of the whole state of the run.

The history that a substitute needs is stored only for members with others of their kind, and only while a member may
still be missed or a role is vacant.
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
from kitrobot.sim.step.substitution import declare_missing, finish_team_step, handle_return, restart_program
from kitrobot.sim.tables import columns as c
from kitrobot.sim.tables import team_columns as tc
from kitrobot.sim.tables.state import State, Team
from kitrobot.sim.team.meetings import is_left_empty
from kitrobot.sim.team.work import is_taken
from kitrobot.verifier.model.team_agreement import Agreement, TeamCommand, TeamState
from kitrobot.verifier.tables import columns as v

ENDS = -1
"""In `TeamCommand`, in place of an actuator: the program of the robot given as the procedure has ended."""


class TeamStatus(NamedTuple):
    """The robots that play a role, as bits by their numbers in the run, and whether the team is over."""

    plays: int
    is_over: bool


def gave_up(team: Team) -> bool:
    """Whether a team has reported that it cannot continue: it is over, or a block has no members left."""
    kinds, members = team.points[tc.P_KIND], team.points[tc.P_MEMBERS]
    return bool(team.numbers[tc.TEAM_OVER]) or any(
        kind == tc.BLOCK and is_left_empty(chosen, team) and team.emptied[chosen] - 2 <= p
        for p, (kind, chosen) in enumerate(zip(kinds, members, strict=True))
    )


class AbsenceAgreement(Agreement):
    """The team of a run whose robots may fail, before the first step of the run.

    Args:
        run: the run.
        actuators: those that take part in team agreement, by their numbers in the run.
    """

    def __init__(self, run: Simulation, actuators: Sequence[int]) -> None:
        robots, programs = run.state.team.robots, run.state.robots.ints[c.PROGRAM]
        places = [
            (int(programs[i]), int(place)) if link >= 0 else None
            for i, (link, place) in enumerate(zip(robots[tc.T_ACTUATOR], robots[tc.T_PLACE], strict=True))
        ]
        leads = tc.SUBSTITUTE in run.state.team.failure
        self._has_spare = [leads and place is not None and places.count(place) > 1 for place in places]
        self._given_up: dict[TeamState, bool] = {}
        super().__init__(run, actuators)
        self.works = len(self._team.holds)
        """How many works the team has."""

    def _copy_state(self, state: State) -> State:
        copied: State = copy.deepcopy(state)
        return replace(copied, clock=[0] * len(state.clock), events=[0] * len(state.events), radio=no_radio())

    # -- what happens

    def after_event(self, agreed: TeamState, robot: int, what: int) -> TeamState:
        """The team's state after a robot fell silent, is heard again, is missed, or lost a unit of work.

        `what` is one of `columns.W_SILENT` and those behind it.
        """
        self._write(agreed)
        state, robots = self._state, self._team.robots
        if what == v.W_SILENT:
            robots[tc.T_SILENT][robot] = 0
        elif what == v.W_BACK:
            handle_return(robot, state)
        elif what in (v.W_MISSED, v.W_ANEW):
            declare_missing(robot, state)
            if what == v.W_ANEW:
                restart_program(robot, state)
        else:
            self._team.holds[what - v.W_FREED][robot] = tc.LOST_UNIT
        return self._read()

    def after(self, agreed: TeamState, told: Sequence[TeamCommand]) -> TeamState:
        made = super().after(agreed, [one for one in told if one.actuator != ENDS])
        ended = [one.procedure for one in told if one.actuator == ENDS]
        if not ended:
            return made
        for robot in ended:
            self._state.robots.ints[c.ENDED][robot] = 1
        return self._read()

    def settled(self, agreed: TeamState) -> TeamState:
        self._write(agreed)
        finish_team_step(self._state)
        return self._read()

    def halts(self, actuator: int) -> bool:
        """Whether a busy actuator, by its number in the run, stops when its program restarts; otherwise it goes on."""
        procedure, done = self._team.halts[actuator], self._state.actuators.ints[c.A_DONE]
        if procedure < 0:
            return False
        saved, done[actuator] = done[actuator], 0
        start(actuator, Command(procedure, 0, 0, 0, 0), 0.0, self._state)
        rests, done[actuator] = bool(done[actuator]), saved
        return rests

    # -- what is seen of it

    def seen(self, agreed: TeamState) -> list[int]:
        """The columns of a team's state in the model's tables, from `G_MEMBERS` on."""
        self._write(agreed)
        team, ended = self._team, self._state.robots.ints[c.ENDED]
        robots = team.robots
        members = [link >= 0 and not over for link, over in zip(robots[tc.T_ACTUATOR], ended, strict=True)]
        leases = zip(team.holds, team.works[tc.W_LEASE], strict=True)
        return [
            _bits(members),
            _bits([silent >= 0 for silent in robots[tc.T_SILENT]]),
            _bits([role >= 0 for role in robots[tc.T_ROLE]]),
            _bits([bool(one) for one in robots[tc.T_MISSED]]),
            int(team.numbers[tc.TEAM_OVER] > 0),
            *(_bits([lease > 0 and is_taken(one) for one in holds]) for holds, lease in leases),
        ]

    def has_ended(self, agreed: TeamState, robot: int) -> bool:
        """Whether a robot's program has ended."""
        return bool(self._of_robot(agreed, 0, robot))

    def status(self, agreed: TeamState) -> TeamStatus:
        """The robots that play a role, and whether the team is over."""
        seen = self.seen(agreed)
        return TeamStatus(seen[v.G_PLAYING], seen[v.G_OVER] > 0)

    def takes_no_part(self, agreed: TeamState, robot: int) -> bool:
        """Whether a robot of the team plays no role in it (any more)."""
        return self.is_member(robot) and self._of_robot(agreed, 3, robot) < 0

    def gave_up(self, agreed: TeamState) -> bool:
        """Whether the team cannot go on, and says so."""
        found = self._given_up.get(agreed)
        if found is None:
            self._write(agreed)
            found = self._given_up[agreed] = gave_up(self._team)
        return found

    def _of_robot(self, agreed: TeamState, row: int, robot: int) -> int:
        """What one of `_robot_rows` holds of a robot."""
        rows = self._place(len(self._rows)) + len(self.actuators)
        return agreed[rows + row * len(self._has_spare) + robot]

    def reduced(self, agreed: TeamState, left: int) -> TeamState:
        """The same state without the history for substitutes of robots that can no longer be missed."""
        self._write(agreed)
        robots = self._team.robots
        silent = any(one >= 0 <= role for one, role in zip(robots[tc.T_SILENT], robots[tc.T_ROLE], strict=True))
        may_be_led = left > 0 or silent or any(robots[tc.T_LEFT])
        ended, members = self._team.points[tc.P_ENDED], self._team.points[tc.P_MEMBERS]
        for branch, has_ended in enumerate(ended):
            if has_ended and not may_be_led and not is_left_empty(members[branch], self._team):
                ended[branch] = 0
        for i in range(len(robots[tc.T_AT])):
            if robots[tc.T_LED][i] >= 0 or robots[tc.T_REPLAYED][i] < robots[tc.T_TO_REPLAY][i]:
                continue
            robots[tc.T_REPLAYED][i] = robots[tc.T_TO_REPLAY][i] = 0
            leads = may_be_led and robots[tc.T_ROLE][i] >= 0
            if not leads:
                robots[tc.T_ANCHOR][i] = robots[tc.T_BRANCH][i] = -1
            if not (leads and self._has_spare[i]):
                robots[tc.T_SINCE][i] = robots[tc.T_ANCHOR_ANSWER][i] = 0
        return self._read()

    # -- states

    def _robot_rows(self) -> list[list[int]]:
        """The additional rows that change; `ENDED` is the first and `T_ROLE` the fourth."""
        robots = self._team.robots
        own = (tc.T_MISSED, tc.T_ROLE, tc.T_SEAT, tc.T_HOLDER, tc.T_ANCHOR, tc.T_ANCHOR_ANSWER, tc.T_SINCE)
        leads = (tc.T_LED, tc.T_REPLAYED, tc.T_TO_REPLAY, tc.T_LEFT, tc.T_BRANCH)
        rows = [robots[row] for row in (tc.T_SILENT, *own, *leads)]
        return [
            self._state.robots.ints[c.ENDED],
            *rows,
            self._team.emptied,
            self._team.points[tc.P_ENDED],
            *self._team.vacated,
        ]

    def _read_robots(self) -> TeamState:
        team = self._team
        silent, since = team.robots[tc.T_SILENT], team.robots[tc.T_SINCE]
        # Since when somebody is silent, or how much too long what leads its substitute is, makes no difference.
        for i, most in enumerate(map(len, team.since)):
            silent[i], since[i] = (0 if silent[i] >= 0 else -1), min(since[i], most + 1)
        past = (_number(row[:count], self._codes()) for row, count in zip(team.since, since, strict=True))
        over = team.numbers[tc.TEAM_OVER]
        return (*(int(one) for row in self._robot_rows() for one in row), *past, int(over))

    def _write_robots(self, values: Iterator[int]) -> None:
        team = self._team
        for row in self._robot_rows():
            for n in range(len(row)):
                row[n] = next(values)
        for row in team.since:
            for n, one in enumerate(_digits(next(values), self._codes())):
                row[n] = one
        team.numbers[tc.TEAM_OVER] = next(values)

    def _codes(self) -> int:
        """The number of codes in the history of a point of the team's program."""
        return 2 * len(self._team.points[tc.P_KIND])


def _bits(flags: Sequence[bool]) -> int:
    return sum(1 << n for n, flag in enumerate(flags) if flag)


def _number(codes: Sequence[int], base: int) -> int:
    """A row of numbers below `base` as one."""
    number = 0
    for code in reversed(codes):
        number = number * (base + 1) + code + 1
    return number


def _digits(number: int, base: int) -> list[int]:
    """What `_number` was made of."""
    codes = []
    while number:
        number, code = divmod(number, base + 1)
        codes.append(code - 1)
    return codes
