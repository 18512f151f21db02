"""Tables of a team before the first step: who plays which role, what sets and groups hold, and the program's points."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from kitrobot.compiler.team.points import ALL, ONE, Point, PointKind, TeamPlan
from kitrobot.lll.tree import FAILURES, QUANTIFIERS, RoleDeclaration
from kitrobot.mission.model import Team as DeclaredTeam
from kitrobot.sim.tables import team_columns as c
from kitrobot.sim.tables.state import Team
from kitrobot.sim.team.meetings import find_members

LEASE_MS = 1000
"""So long a robot may be silent before its team misses it."""
KINDS = tuple(PointKind)
"""The kinds of points in the order of their numbers in `team_columns`."""
_COMBINED: Mapping[str, int] = {ONE: c.ONE, **dict(zip(QUANTIFIERS, (c.ANY, c.EVERY, c.MOST), strict=True))}


def no_team() -> Team:
    """The tables of a run without a team's program."""
    return Team(
        numbers=[0] * c.TEAM_NUMBERS,
        points=_rows(c.POINT_ROWS),
        robots=_rows(c.TEAM_ROWS),
        set_first=[],
        names=_rows(c.NAME_ROWS),
        members=[],
        groups=[],
        vacated=[],
        within=[],
        failure=[],
        emptied=[],
        since=[],
        works=_rows(c.WORK_ROWS),
        holds=[],
        until=[],
        waits=[],
        halts=[],
        first_cells=[],
        first_threads=[],
        first_pars=[],
        kept=_rows(c.KEPT_ROWS),
        kept_passes=[],
    )


def _rows(count: int, length: int = 0) -> list[list[int]]:
    return [[0] * length for _ in range(count)]


@dataclass(frozen=True)
class TeamMember:
    """A robot that runs a team's program: its number in the run, its name, its kind, its actuator's number, and the
    number of the place where it stands for good, -1 for none.
    """

    robot: int
    name: str
    kind: str
    actuator: int = -1
    place: int = -1


@dataclass
class TeamSetup:
    """A team before its tables are made: its program's points, what it declares, and who runs the program."""

    plan: TeamPlan
    declared: DeclaredTeam
    members: list[TeamMember] = field(default_factory=list)

    @property
    def most_events(self) -> int:
        """The most that can be told of the team in one step: who is missed, is back, takes over, moves, lost a unit."""
        return len(self.members) * (
            4 + len(self.declared.works) + sum(point.kind is PointKind.MOVE for point in self.plan.points)
        )


@dataclass(frozen=True)
class InitialState:
    """How machines and devices are when their program begins: of each program its rows, of each actuator the number of
    the procedure that stops it, or -1.
    """

    cells: list[list[int]]
    threads: list[list[int]]
    pars: list[list[int]]
    halts: list[int]


def assign_roles(roles: Sequence[RoleDeclaration], members: Sequence[TeamMember]) -> dict[int, int]:
    """Robot → role, by numbers: each role in the order of declaration has up to `most` robots of its kind, in team
    order, but those that later roles need at least. Who is not in it is spare.
    """
    playing: dict[int, int] = {}
    for number, role in enumerate(roles):
        free = [one.robot for one in members if one.kind == role.robot and one.robot not in playing]
        needed = sum(later.least for later in roles[number + 1 :] if later.robot == role.robot)
        wanted = min(role.most, max(role.least, len(free) - needed))
        playing.update(dict.fromkeys(free[:wanted], number))
    return playing


def team_tables(setup: TeamSetup, robots: int, step_ms: float, beginnings: InitialState) -> Team:
    """The tables of a team among so many robots of a run."""
    return _TeamTableBuilder(setup, robots, step_ms).team(math.ceil(LEASE_MS / step_ms), beginnings)


class _TeamTableBuilder:
    def __init__(self, setup: TeamSetup, robots: int, step_ms: float) -> None:
        self.plan = setup.plan
        self.declared = setup.declared
        self.step_ms = step_ms
        self.roles = {role.name: number for number, role in reversed(list(enumerate(setup.declared.roles)))}
        self.groups = {name: number for number, name in enumerate(self.plan.groups)}
        failures = {group.name: FAILURES.index(group.failure) for group in reversed(setup.declared.groups)}
        self.failures = [failures.get(name, 0) for name in self.groups]
        self.agents = {one.name: one.robot for one in setup.members}
        self.members = setup.members
        self.playing = assign_roles(setup.declared.roles, setup.members)
        self.count = robots
        self.sets: dict[frozenset[str], int] = {ALL: 0}

    def team(self, lease: int, beginnings: InitialState) -> Team:
        points = [list(row) for row in zip(*map(self.point, self.plan.points), strict=True)] or _rows(c.POINT_ROWS)
        first, names = [0], _rows(c.NAME_ROWS)
        for chosen in self.sets:
            for name in sorted(chosen):
                what, which = self.meaning(name)
                if what >= 0:
                    names[c.N_WHAT].append(what)
                    names[c.N_WHICH].append(which)
            first.append(len(names[0]))
        team = Team(
            numbers=[lease if number == c.TEAM_LEASE else 0 for number in range(c.TEAM_NUMBERS)],
            points=self.with_blocks(points),
            robots=self.robots(),
            set_first=first,
            names=names,
            members=_rows(len(self.sets), self.count),
            groups=[self.first_members(name) for name in self.plan.groups],
            vacated=_rows(len(self.plan.groups), self.count),
            within=[self.within(name) for name in self.plan.groups],
            failure=self.failures,
            emptied=[0] * len(self.sets),
            since=_rows(self.count, c.MOST_SINCE if c.SUBSTITUTE in self.failures else 0),
            works=self.works(),
            holds=_rows(len(self.declared.works), self.count),
            until=_rows(len(self.declared.works), self.count),
            waits=[[-1] * self.count for _ in self.declared.works],
            halts=beginnings.halts,
            first_cells=beginnings.cells,
            first_threads=beginnings.threads,
            first_pars=beginnings.pars,
            kept=_rows(c.KEPT_ROWS, self.count),
            kept_passes=[0] * len(self.plan.points),
        )
        find_members(team)
        return team

    def point(self, point: Point) -> list[int]:
        row = [0] * c.POINT_ROWS
        row[c.P_KIND] = KINDS.index(point.kind)
        row[c.P_MEMBERS], row[c.P_VOTERS] = self.set_number(point.members), self.set_number(point.asked)
        row[c.P_QUANTIFIER] = _COMBINED[point.quantifier]
        row[c.P_NEGATED], row[c.P_TIMES] = int(point.negated), point.times
        row[c.P_FIRST], row[c.P_LAST] = point.leads
        row[c.P_BLOCK] = row[c.P_JOINS] = -1
        row[c.P_SOURCE], row[c.P_TARGET] = (self.groups.get(name, -1) for name in point.moves)
        return row

    def works(self) -> list[list[int]]:
        """All units of each work, and its lease."""
        rows = _rows(c.WORK_ROWS, len(self.declared.works))
        for number, work in enumerate(self.declared.works):
            rows[c.W_LEFT][number] = work.units
            rows[c.W_LEASE][number] = math.ceil((work.lease or 0) * 1000 / self.step_ms)
        return rows

    def with_blocks(self, points: list[list[int]]) -> list[list[int]]:
        """The points, of which each meeting behind a block names it: the outermost one that ends there; and each branch
        the meeting behind all branches beside it.
        """
        for number in reversed(range(len(self.plan.points))):
            point = self.plan.points[number]
            behind = max(number, point.leads[1]) + 1
            meets = behind < len(self.plan.points) and self.plan.points[behind].kind is PointKind.MEET
            if point.kind is PointKind.BLOCK and meets:
                points[c.P_BLOCK][behind] = number
            elif point.kind is PointKind.BRANCH:
                joins = behind if meets else points[c.P_JOINS][behind]
                points[c.P_JOINS][number], points[c.P_BLOCK][joins] = joins, -1
        return points

    def set_number(self, names: frozenset[str]) -> int:
        return self.sets.setdefault(names, len(self.sets))

    def meaning(self, name: str) -> tuple[int, int]:
        """What a name stands for, a role that is a group too for that group; (-1, -1) for nobody."""
        known = ((c.GROUP, self.groups), (c.ROLE, self.roles), (c.AGENT, self.agents))
        return next(((what, table[name]) for what, table in known if name in table), (-1, -1))

    def robots(self) -> list[list[int]]:
        rows = _rows(c.TEAM_ROWS, self.count)
        for row in (c.T_ACTUATOR, c.T_ROLE, c.T_HOLDER, c.T_AT, c.T_SILENT, c.T_ANCHOR, c.T_LED, c.T_BRANCH):
            rows[row] = [-1] * self.count
        rows[c.T_SEAT] = list(range(self.count))
        for one in self.members:
            rows[c.T_ACTUATOR][one.robot] = one.actuator
            rows[c.T_PLACE][one.robot] = one.place
        for robot, role in self.playing.items():
            rows[c.T_ROLE][robot] = role
            rows[c.T_HOLDER][robot] = robot
        return rows

    def first_members(self, group: str) -> list[int]:
        """The robots that a group holds itself."""
        row = [0] * self.count
        for name in self.plan.groups[group]:
            if name == group or name not in self.groups:
                role, agent = self.roles.get(name), self.agents.get(name)
                for robot, plays in self.playing.items():
                    if plays == role if role is not None else robot == agent:
                        row[robot] = 1
        return row

    def within(self, group: str) -> list[int]:
        """Which groups are in a group, it itself among them."""
        waiting, found = [group], {group}
        while waiting:
            for name in self.plan.groups[waiting.pop()]:
                if name in self.groups and name not in found:
                    found.add(name)
                    waiting.append(name)
        return [int(name in found) for name in self.plan.groups]
