"""One team twice: as the tables of the simulator and as those of the protocol, and what is put into both.

The team has four ants in two groups, and two spare ones where its groups are substituted. Each group has a meeting and
a question of its own, and both have one together; there is a work with a lease and one without. What only one of the
two defines is not done (docs/team-protocol.md, "The simulator's tables").
"""

from __future__ import annotations

import random

from kitrobot.compiler import ALL, Point, PointKind, TeamPlan
from kitrobot.lll import QUANTIFIERS, Quantifier, parse_team
from kitrobot.sim import columns as c
from kitrobot.sim import team_columns as tc
from kitrobot.sim.meetings import come
from kitrobot.sim.substitution import look_for_silent, settle
from kitrobot.sim.work import finish_unit, take_unit
from kitrobot.team import Announce, Charter, Done, Free, Group, MeetingRule, Move, Role, Seat, Take, Work
from kitrobot.team.applying import applied
from kitrobot.team.changes import Change, Counted, Granted, NotCounted
from kitrobot.team.charter import Failure
from kitrobot.team.commands import Body, Command, ViewChange
from kitrobot.team.meeting import participants, result_of
from kitrobot.team.tables import Tables, first_tables
from tests.sim.team_building import RunningTeam
from tests.team_programs.making import TeamMaker

PROGRAM = """role reds: ant 2;
role blues: ant 2;
group red = reds on failure {failure};
group blue = blues on failure {failure};
work Boxes = {units} lease 1;
work Balls = 2;

ParOfSeq reds (Boxes.Take(); Balls.Take(););
"""
GROUPS = ("red", "blue")
WORKS = ("Boxes", "Balls")


class Simulated:
    """A team in the tables of the simulator."""

    def __init__(self, failure: Failure, units: int, plan: list[Point], spares: int) -> None:
        parsed = parse_team(PROGRAM.format(failure=failure, units=units))
        assert parsed.ok, parsed.diagnostics
        maker = TeamMaker(random.Random(0))
        roles = ("reds", "reds", "blues", "blues", *[""] * spares)
        maker.agents = {f"a-{n}": ("ant", role) for n, role in enumerate(roles)}
        team = RunningTeam(maker, parsed.program, 1)
        team.plan = TeamPlan(tuple(plan), team.plan.groups)
        self.groups = list(team.plan.groups)
        self.run = team.anew()
        self.state = self.run.state
        self.team = self.state.team
        # How long somebody is silent before it is missed is for the host; here it is no time.
        self.team.numbers[tc.TEAM_LEASE] = 0
        self.late = 0
        """How often a robot said that a unit was done which was not its any more."""

    def come(self, i: int, p: int, answer: int) -> None:
        come(i, p, answer, self.state)

    def take(self, i: int, w: int) -> None:
        agent = self.run.members[i]
        number = next(n for n, part in enumerate(agent.robot.actuators) if part.name == WORKS[w])
        first = self.state.robots.ints[c.ACTUATOR_INDEX][i]
        take_unit(i, w, self.state.actuators.actuator_index[first + number], self.state)

    def finish(self, i: int, w: int) -> None:
        finish_unit(i, w, self.state)

    def harm(self, i: int, kind: str) -> None:
        self.run.harm(f"a-{i}", kind)

    def settle(self, steps: int) -> None:
        """So many steps later: who is silent is missed, and all is agreed that can be."""
        self.state.clock[c.TICK] += steps
        look_for_silent(self.state.clock[c.TICK], self.state)
        settle(self.state)
        while self.team.numbers[tc.TEAM_FRESH]:
            settle(self.state)
        self.late += sum(event.text.startswith("was too late") for event in self.run.happened())
        self.state.clock[c.EVENTS] = 0

    def lead(self) -> dict[int, int]:
        """Lets substitutes go on to where they are led to; of each, what it is answered there."""
        robots = self.team.robots
        led = {i: p for i, p in enumerate(robots[tc.T_LED]) if p >= 0}
        for i, p in led.items():
            come(i, p, 0, self.state)
        return {i: robots[tc.T_ANSWER][i] for i in led}


class Pair:
    """The two forms of a team. `failure` is what its groups do; robots move from group to group only where they drop.

    Attributes:
        standing: for each robot, the point and the occurrence of it at which it waits.
        latest: for each robot, the point and the occurrence that it, or whom it stands for, went on from last.
        granted: for each robot and work, the unit and number that it was given and has not said to be done.
        skipped: how much was not done, because only one of the two defines it.
    """

    def __init__(self, failure: Failure, units: int, chance: random.Random) -> None:
        spares = 2 if failure == "substitute" else 0
        self.count = 4 + spares
        self.points: list[Point] = []
        meetings: list[MeetingRule] = []
        for groups in ((0,), (1,), (0, 1)):
            names = frozenset((GROUPS[groups[0]],)) if len(groups) == 1 else ALL
            quantifier: Quantifier = chance.choice(QUANTIFIERS)
            self.points += [Point(PointKind.MEET, names), Point(PointKind.ASK, names, names, quantifier)]
            meetings += [MeetingRule(groups), MeetingRule(groups, quantifier)]
        for source, target in ((0, 1), (1, 0)) if failure == "drop" else ():
            count = chance.randrange(3)
            self.points.append(Point(PointKind.MOVE, ALL, times=count, moves=(GROUPS[source], GROUPS[target])))
            meetings.append(MeetingRule((0, 1), moves=(Move(source, target, count),)))
        everyone = tuple(range(self.count))
        roles = (Role(everyone, 2, 0), Role(everyone, 2, 1)) if failure == "substitute" else ()
        teams = (Group((0, 1), failure), Group((2, 3), failure))
        self.charter = Charter(self.count, roles, teams, tuple(meetings), (Work(units, 1000), Work(2)))
        self.tables = first_tables(self.charter)
        self.sim = Simulated(failure, units, self.points, spares)
        self.lives = [0] * self.count
        self.standing: list[tuple[int, int] | None] = [None] * self.count
        self.latest: list[tuple[int, int] | None] = [None] * self.count
        self.passed = [0] * len(self.points)
        self.granted: list[dict[int, tuple[int, int]]] = [{} for _ in everyone]
        self.given_at: dict[tuple[int, int, int], int] = {}
        self.answers: dict[int, int] = {}
        self.not_counted = self.counted = self.skipped = 0

    # -- what is done to both

    def comes(self, i: int, p: int, answer: int) -> None:
        answer = answer if self.points[p].kind is PointKind.ASK else 0
        if not self.is_free(i) or i not in participants(self.charter, self.tables, p):
            return
        self.standing[i] = p, self.passed[p]
        if self.is_told(i, Announce(p, self.passed[p], answer)):
            self.sim.come(i, p, answer)
            self.settled()
        else:
            self.standing[i] = None

    def takes(self, i: int, w: int) -> None:
        row = [m for m in self.tables.works[w].waiting if self.tables.view.has(m)]
        holds = any(unit.holder == i for unit in self.tables.works[w].units)
        if self.is_free(i) and not holds and all(m < i for m in row) and self.is_told(i, Take(w)):
            self.sim.take(i, w)
            self.settled()

    def finishes(self, i: int, w: int) -> None:
        if self.is_free(i) and w in self.granted[i]:
            unit, number = self.granted[i][w]
            if self.is_told(i, Done(w, unit, number)):
                del self.granted[i][w]
                self.sim.finish(i, w)
                self.settled()

    def fails(self, i: int, kind: str) -> None:
        """A robot fails, stalls or loses its radio, and is missed."""
        seats = self.tables.view.seats
        others = [seat.member for seat in seats if seat.member != i]
        if not others or len(others) == len(seats):
            return
        players = self.tables.players
        if self.is_told(others[0], ViewChange(self.tables.view.number, (i,), ())):
            self.standing[i], self.granted[i] = None, {}
            self.answers.pop(i, None)
            for before, after in zip(players, self.tables.players, strict=True):
                for spare in set(after) - set(before):
                    self.latest[spare] = self.latest[i]
            self.sim.harm(i, kind)
            self.settled()

    def comes_back(self, i: int) -> None:
        """A robot is back, and plays a role that is vacant beside somebody else; where nobody else plays it, the two
        forms differ.
        """
        if self.tables.view.has(i):
            return
        change = ViewChange(self.tables.view.number, (), (Seat(i, self.lives[i] + 1),))
        first, players = self.tables.view.seats[0].member, self.tables.players
        after = self.after(self.tables, first, change)[0].players
        beside = [before for before, now in zip(players, after, strict=True) if before != now]
        if () not in beside and self.is_told(first, change):
            self.lives[i] += 1
            self.latest[i] = self.latest[beside[0][0]] if beside else None
            self.sim.harm(i, "revive")
            self.settled()

    def waits(self, steps: int) -> None:
        """Time passes; the first of the view says which leases are over."""
        step, lease = self.sim.state.clock[c.TICK] + steps, self.sim.team.works[tc.W_LEASE][0]
        bodies = [
            Free(0, n, unit.number)
            for n, unit in enumerate(self.tables.works[0].units)
            if unit.holder >= 0 and step - self.given_at[0, n, unit.number] >= lease
        ]
        first = self.tables.view.seats[0].member
        if self.is_told(first, *bodies, step=step):
            self.settled(steps)

    def is_free(self, i: int) -> bool:
        """Whether a robot plays a role and waits for nothing."""
        plays = any(i in group for group in self.tables.groups) and self.tables.view.has(i)
        waits = any(i in work.waiting for work in self.tables.works)
        return plays and not waits and self.standing[i] is None

    # -- the protocol

    def after(self, tables: Tables, member: int, body: Body) -> tuple[Tables, list[Change]]:
        last = tables.applied[member]
        return applied(self.charter, tables, (Command(Seat(member, last.life), last.last + 1, body),))

    def is_told(self, member: int, *bodies: Body, step: int | None = None) -> bool:
        """Whether the protocol takes these commands of a member; it does not where the simulator says otherwise."""
        tables, told = self.tables, list[Change]()
        for body in bodies:
            tables, more = self.after(tables, member, body)
            told += more
        passing = [result_of(meeting, n) for meeting, n in zip(tables.meetings, self.passed, strict=True)]
        stays = [at for at in self.standing if at and result_of(tables.meetings[at[0]], at[1]) is None]
        for work in tables.works:
            holders = [unit.holder for unit in work.units if unit.holder >= 0]
            stand = [i for i in holders if self.standing[i] in stays]
            if any(tables.view.has(m) for m in work.waiting) and len(stand) == len(holders):
                self.skipped += 1
                return False
        self.tables = tables
        for i, at in enumerate(self.standing):
            if at and (answer := result_of(tables.meetings[at[0]], at[1])) is not None:
                self.answers[i], self.latest[i], self.standing[i] = answer, at, None
        self.passed = [n + (result is not None) for n, result in zip(self.passed, passing, strict=True)]
        now = self.sim.state.clock[c.TICK] if step is None else step
        for change in told:
            if isinstance(change, Granted) and change.unit >= 0:
                self.granted[change.member][change.work] = change.unit, change.number
                self.given_at[change.work, change.unit, change.number] = now
            self.not_counted += isinstance(change, NotCounted)
            self.counted += isinstance(change, Counted)
        return True

    # -- whether both say the same

    @property
    def is_over(self) -> bool:
        """Whether nobody has a role any more, or a group has ended the team."""
        return self.tables.aborted >= 0 or not any(self.tables.groups)

    def settled(self, steps: int = 0) -> None:
        """The simulator does what follows, and then both are the same."""
        self.sim.settle(steps)
        over = self.sim.team.numbers[tc.TEAM_OVER] == tc.OVER_ABORT
        assert over == (self.tables.aborted >= 0)
        if over:
            group = self.sim.groups[self.sim.team.numbers[tc.TEAM_OVER_GROUP]]
            assert group == GROUPS[self.tables.aborted]
        if self.is_over:
            return
        for i, answer in self.sim.lead().items():
            at = self.latest[i]
            assert at is not None
            kept = result_of(self.tables.meetings[at[0]], at[1])
            self.answers[i] = answer if kept is None else kept
        self.compare()

    def compare(self) -> None:
        team, tables, robots = self.sim.team, self.tables, range(self.count)
        assert [at[0] if at else -1 for at in self.standing] == list(team.robots[tc.T_AT])
        for i, answer in self.answers.items():
            assert answer == team.robots[tc.T_ANSWER][i]
        for p in range(len(self.points)):
            there = team.members[team.points[tc.P_MEMBERS][p]]
            assert tuple(i for i in robots if there[i]) == participants(self.charter, tables, p)
        for g, group in enumerate(tables.groups):
            row = team.groups[self.sim.groups.index(GROUPS[g])]
            assert tuple(i for i in robots if row[i]) == group
        for role, players in enumerate(tables.players):
            assert tuple(i for i in robots if team.robots[tc.T_ROLE][i] == role) == players
        for w, work in enumerate(tables.works):
            assert team.works[tc.W_LEFT][w] == work.left
            held = sorted(unit.holder for unit in work.units if unit.holder >= 0)
            assert [i for i in robots if team.holds[w][i] == tc.HAS_UNIT] == held
            assert team.works[tc.W_TAKEN][w] == len(held)
            row = [m for m in work.waiting if tables.view.has(m)]
            assert [i for i in robots if team.waits[w][i] >= 0] == row
            assert team.works[tc.W_WAITING][w] == len(row)
        assert self.sim.late == self.not_counted
