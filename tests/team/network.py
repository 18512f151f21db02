"""A network of members with every fault that the protocol tolerates, and the laws that hold at every moment of it.

All is decided by a seed and a list of phases. Clocks run at different speeds; that of a stopped member runs on.
"""

from __future__ import annotations

import random
from collections.abc import Callable
from dataclasses import dataclass, field

from kitrobot.team.changes import AppliedNote, Change
from kitrobot.team.charter import Charter
from kitrobot.team.commands import Note, Seat
from kitrobot.team.consensus import is_quorum
from kitrobot.team.events import Event, IncomingMessage, Time, Write
from kitrobot.team.member import step
from kitrobot.team.messages import EVERYONE, Message
from kitrobot.team.state import Member, initial_state, may_act
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


def team(members: int) -> Charter:
    """A team that shares two variables."""
    return Charter(members, variables=2)


@dataclass
class Robot:
    """The program of a member: gives notes and writes variables, one after the other.

    Attributes:
        given: how many notes it gave; noted: those of all members that took effect here, in order.
        viewed_at: when it learned of the view that it knows, by its own clock.
    """

    state: Member
    speed: float
    offset: int
    viewed_at: int
    given: int = 0
    noted: list[tuple[Seat, tuple[int, ...]]] = field(default_factory=list)


class Network:
    def __init__(self, charter: Charter, seed: int, rounds: int = 1000) -> None:
        self.charter = charter
        self.rounds = rounds
        self.random = random.Random(seed)
        self.now = 0
        self.under_way: list[tuple[int, int, Message]] = []
        self.robots: dict[int, Robot] = {}
        self.phase = Phase(0)
        self.tables: dict[int, Tables] = {0: initial_state(charter, Seat(0, 0), 0).tables}
        self.given: set[tuple[Seat, tuple[int, ...]]] = set()
        self.lives = [0] * charter.members
        self.sent = 0
        self.blocked: Callable[[int, int, Message], bool] = lambda sender, to, message: False
        for member in range(charter.members):
            self.start(member)

    def start(self, member: int) -> None:
        """A member starts, in its next life if it had one."""
        speed, offset = self.random.choice((1.0, 0.96, 1.04)), self.random.randrange(10_000)
        now = int(self.now * speed) + offset
        state = initial_state(self.charter, Seat(member, self.lives[member]), now)
        self.lives[member] += 1
        self.robots[member] = Robot(state, speed, offset, now)

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
                    self.event(to, IncomingMessage(message, more=self.random.random() < 0.2))
            for member in list(self.robots):
                if member not in phase.stopped:
                    self.event(member, Time())
                    if not phase.idle:
                        self.program(member)
            self.check_rights()

    def event(self, member: int, event: Event) -> None:
        robot = self.robots[member]
        before, view = robot.state.log.slot, robot.state.tables.view
        stepped = step(self.charter, robot.state, self.clock(robot), event)
        robot.state = stepped.state
        if stepped.state.tables.view != view:
            robot.viewed_at = self.clock(robot)
        for to, message in stepped.messages:
            for other in range(self.charter.members) if to == EVERYONE else (to,):
                if other != member:
                    self.send(member, other, message)
        if stepped.state.log.slot != before:
            self.check_log(robot.state)
        for change in stepped.changes:
            self.note(robot, change)

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
        """The next thing that the robot does, if it is in the view and few of its notes wait."""
        robot = self.robots[member]
        state = robot.state
        if state.seat not in state.tables.view.seats or len(state.log.pending) >= 3 or robot.given >= self.rounds:
            return
        robot.given += 1
        numbers = (robot.given, self.random.randrange(9))
        self.given.add((state.seat, numbers))
        self.event(member, Note(numbers))
        if self.random.randrange(4) == 0:
            self.event(member, Write(self.random.randrange(2), self.random.randrange(100)))

    def note(self, robot: Robot, change: Change) -> None:
        """A note takes effect once, in the order of its member, and only if it was given."""
        if isinstance(change, AppliedNote):
            note = change.seat, change.numbers
            assert note in self.given
            assert all(seat != change.seat or numbers[0] < change.numbers[0] for seat, numbers in robot.noted)
            robot.noted.append(note)

    def check_log(self, state: Member) -> None:
        """What one member knows to be decided, another one knows too."""
        slot, tables = state.log.slot, state.tables
        assert self.tables.setdefault(slot, tables) == tables, f"two members decide slot {slot} differently"

    def check_rights(self) -> None:
        """A robot that a view has left may not act once another may have taken its place (`Charter.hold`)."""
        acting = [robot.state.seat for robot in self.robots.values() if self.acts(robot)]
        for robot in self.robots.values():
            if self.clock(robot) - robot.viewed_at >= self.charter.hold:
                view = robot.state.tables.view
                newer = [one.state.tables.view.number for one in self.robots.values()]
                gone = [seat for seat in acting if seat not in view.seats]
                assert view.number < max(newer) or not gone, f"{gone} act after the view has left them"

    def acts(self, robot: Robot) -> bool:
        return may_act(self.charter, robot.state, self.clock(robot))

    def can_heal(self) -> bool:
        """Whether those that run can decide: a quorum of the newest view that anyone knows is among them."""
        views = [robot.state.tables.view for robot in self.robots.values()]
        view = max(views, key=lambda view: view.number)
        ranks = [i for i, seat in enumerate(view.seats) if self.seat(seat.member) == seat]
        return is_quorum(ranks, len(view.seats))

    def seat(self, member: int) -> Seat | None:
        return self.robots[member].state.seat if member in self.robots else None

    def check_healed(self) -> None:
        """All copies are equal, everyone that runs is in the view and may act, nothing waits."""
        states = [robot.state for robot in self.robots.values()]
        first = states[0]
        assert {state.seat for state in states} == set(first.tables.view.seats)
        assert all(state.log.slot == first.log.slot for state in states)
        assert all(state.tables == first.tables for state in states)
        assert all(state.store == first.store for state in states)
        assert all(not state.log.pending and state.membership.heard for state in states)
        assert all(self.acts(robot) for robot in self.robots.values())
