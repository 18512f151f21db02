"""A network of members with every fault that the protocol tolerates, and the laws that hold at every moment of it.

All is decided by a seed and a list of phases. Clocks run at different speeds; that of a stopped member runs on.
"""

from __future__ import annotations

import random
from collections import defaultdict
from collections.abc import Callable
from dataclasses import dataclass, field

from kitrobot.team import (
    EVERYONE,
    Announce,
    Change,
    Charter,
    Done,
    Event,
    Granted,
    Group,
    MeetingRule,
    Member,
    Message,
    Passed,
    Received,
    Role,
    Seat,
    Take,
    Time,
    Work,
    Write,
    first_state,
    may_act,
    step,
)
from kitrobot.team.decision import is_quorum
from kitrobot.team.meeting import combined, participants
from kitrobot.team.tables import Tables

STEP = 25
HEALING = 14_000
"""Ms within which a healed network has made all copies equal and gone on: some rounds of suspicion and patience."""


@dataclass(frozen=True)
class Phase:
    """Some time with these faults; loss and doubling in percent, delay in ms, `side` is cut off from the others.

    `crash` and `starts` are members that crash, and that start again, when it begins; `idle`: no program goes on.
    """

    ms: int
    loss: int = 0
    doubled: int = 0
    delay: int = 0
    side: frozenset[int] = frozenset()
    stopped: frozenset[int] = frozenset()
    crash: int = -1
    starts: int = -1
    idle: bool = False


def team(members: int, units: int = 6) -> Charter:
    """A team: all but the last in a group that substitutes and plays two roles, the last a spare."""
    everyone = tuple(range(members))
    inside = everyone[:-1] if members > 2 else everyone
    return Charter(
        members=members,
        roles=(Role(everyone, 1, 0), Role(everyone, 1, 0)),
        groups=(Group(inside, "substitute"),),
        meetings=(MeetingRule((0,), "any"), MeetingRule((0,), "most")),
        works=(Work(units, lease=4000),),
        variables=2,
    )


@dataclass
class Robot:
    """The program of a member: meets, takes a unit, meets again, works, writes; round after round."""

    state: Member
    speed: float
    offset: int
    place: tuple[int, int] | None = None
    asks: bool = False
    holds: list[tuple[int, int, int]] = field(default_factory=list)


class Network:
    def __init__(self, charter: Charter, seed: int, rounds: int = 1000) -> None:
        self.charter = charter
        self.rounds = rounds
        self.random = random.Random(seed)
        self.now = 0
        self.under_way: list[tuple[int, int, Message]] = []
        self.robots: dict[int, Robot] = {}
        self.phase = Phase(0)
        self.tables: dict[int, Tables] = {0: first_state(charter, Seat(0, 0), 0).tables}
        self.announced: dict[tuple[int, int], dict[int, int]] = defaultdict(dict)
        self.answers: dict[tuple[int, int], int] = {}
        self.counted: set[tuple[int, int]] = set()
        self.lives = [0] * charter.members
        self.sent = 0
        self.blocked: Callable[[int, int, Message], bool] = lambda sender, to, message: False
        for member in range(charter.members):
            self.start(member)

    def start(self, member: int) -> None:
        """A member starts, in its next life if it had one."""
        speed, offset = self.random.choice((1.0, 0.96, 1.04)), self.random.randrange(10_000)
        state = first_state(self.charter, Seat(member, self.lives[member]), int(self.now * speed) + offset)
        self.lives[member] += 1
        self.robots[member] = Robot(state, speed, offset)

    def run(self, phase: Phase) -> None:
        """Goes on under the faults of a phase."""
        self.phase = phase
        if phase.crash in self.robots:
            del self.robots[phase.crash]
        if phase.starts >= 0 and phase.starts not in self.robots:
            self.start(phase.starts)
        end = self.now + phase.ms
        while self.now < end:
            self.now += STEP
            due = [letter for letter in self.under_way if letter[0] <= self.now]
            self.under_way = [letter for letter in self.under_way if letter[0] > self.now]
            self.random.shuffle(due)
            for at, to, message in due:
                if to in phase.stopped:
                    self.under_way.append((at + STEP, to, message))
                elif to in self.robots:
                    self.event(to, Received(message, more=self.random.random() < 0.2))
            for member in list(self.robots):
                if member not in phase.stopped:
                    self.event(member, Time())
                    if not phase.idle:
                        self.program(member)
            self.check_roles()

    def event(self, member: int, event: Event) -> None:
        robot = self.robots[member]
        before = robot.state.log.slot
        stepped = step(self.charter, robot.state, self.clock(robot), event)
        robot.state = stepped.state
        for to, message in stepped.messages:
            for other in range(self.charter.members) if to == EVERYONE else (to,):
                if other != member:
                    self.send(member, other, message)
        if stepped.state.log.slot != before:
            self.check_log(robot.state)
        for change in stepped.changes:
            self.told(member, robot, change)

    def clock(self, robot: Robot) -> int:
        return int(self.now * robot.speed) + robot.offset

    def send(self, member: int, to: int, message: Message) -> None:
        self.sent += 1
        phase = self.phase
        if self.blocked(member, to, message):
            return
        if (member in phase.side) != (to in phase.side) or self.random.randrange(100) < phase.loss:
            return
        for _ in range(2 if self.random.randrange(100) < phase.doubled else 1):
            self.under_way.append((self.now + self.random.randint(1, 1 + phase.delay), to, message))

    def program(self, member: int) -> None:
        """The next thing that the robot does, if it plays in the group and waits for nothing."""
        robot = self.robots[member]
        tables = robot.state.tables
        inside = robot.state.seat in tables.view.seats and member in tables.groups[0]
        if not inside:
            robot.place = None
            return
        if robot.holds and self.random.randrange(4) == 0:
            self.event(member, Done(*robot.holds.pop()))
        if robot.place is not None:
            return
        rounds = [r.occurrence for m in tables.meetings for r in m.results] + [
            said.occurrence - 1 for m in tables.meetings for said in m.announced
        ]
        done = [max((r.occurrence for r in m.results), default=-1) for m in tables.meetings]
        number = 0 if done[0] == done[1] else 1
        occurrence = done[number] + 1
        if max(rounds, default=-1) >= self.rounds:
            return
        if number == 1 and not robot.asks:
            robot.asks = True
            self.event(member, Take(0))
            self.event(member, Write(self.random.randrange(2), self.random.randrange(100)))
        robot.place = (number, occurrence)
        answer = (member * 7 + occurrence * 3 + number) % 2
        self.announced[robot.place].setdefault(member, answer)
        self.event(member, Announce(number, occurrence, self.announced[robot.place][member]))

    def told(self, member: int, robot: Robot, change: Change) -> None:
        """Laws of single changes."""
        if isinstance(change, Passed):
            place = (change.meeting, change.occurrence)
            assert self.answers.setdefault(place, change.answer) == change.answer, "a question has one answer"
            if robot.place == place:
                robot.place = None
        elif isinstance(change, Granted) and change.member == member:
            robot.asks = False
            if change.unit >= 0:
                robot.holds.append((change.work, change.unit, change.number))

    def check_log(self, state: Member) -> None:
        """What one member knows to be decided, another one knows too; a meeting ends as its members announced."""
        slot, tables = state.log.slot, state.tables
        new = slot not in self.tables
        assert self.tables.setdefault(slot, tables) == tables, f"two members decide slot {slot} differently"
        before = self.tables.get(slot - 1)
        if before is None or not new:
            return
        for number, (old, after) in enumerate(zip(before.meetings, tables.meetings, strict=True)):
            for result in set(after.results) - set(old.results):
                live = set(participants(self.charter, tables, number)) & set(participants(self.charter, before, number))
                said = self.announced[number, result.occurrence]
                assert live <= said.keys(), "a meeting was over before all its members came"
                if before.view == tables.view:
                    answers = [said[member] for member in live]
                    assert result.answer == combined(self.charter.meetings[number].quantifier, answers)
        for number, (was, now) in enumerate(zip(before.works, tables.works, strict=True)):
            for index, (a, b) in enumerate(zip(was.units, now.units, strict=True)):
                assert b.number >= a.number
                assert b.done or not a.done, "a unit that was done is not"
                if b.done and not a.done:
                    assert (number, index) not in self.counted, "a unit is counted as done once"
                    self.counted.add((number, index))

    def check_roles(self) -> None:
        for number, role in enumerate(self.charter.roles):
            acting = [m for m, r in self.robots.items() if may_act(self.charter, r.state, number, self.clock(r))]
            assert len(acting) <= role.wanted, f"{acting} act in one role at the same moment"

    def can_heal(self) -> bool:
        """Whether those that run can decide: a quorum of the newest view that anyone knows is among them."""
        views = [robot.state.tables.view for robot in self.robots.values()]
        view = max(views, key=lambda view: view.number)
        ranks = [i for i, seat in enumerate(view.seats) if self.seat(seat.member) == seat]
        return is_quorum(ranks, len(view.seats))

    def seat(self, member: int) -> Seat | None:
        return self.robots[member].state.seat if member in self.robots else None

    def check_healed(self) -> None:
        """All copies are equal, everyone that runs is in the view, all roles are played, nothing waits."""
        states = [robot.state for robot in self.robots.values()]
        first = states[0]
        assert {state.seat for state in states} == set(first.tables.view.seats)
        assert all(state.log.slot == first.log.slot for state in states)
        assert all(state.tables == first.tables for state in states)
        assert all(state.store == first.store for state in states)
        assert all(not state.log.pending and state.membership.heard for state in states)
        playing = {m for players in first.tables.players for m in players}
        assert len(playing) == min(len(states), len(self.charter.roles))
        for number in range(len(self.charter.roles)):
            acting = [m for m, r in self.robots.items() if may_act(self.charter, r.state, number, self.clock(r))]
            assert tuple(acting) == first.tables.players[number]
