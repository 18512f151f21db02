"""A fleet on a network in memory, with time that passes as it is told: every fault is decided by a seed."""

from __future__ import annotations

import random
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import partial

from kitrobot.fleet.body_messages import Frame, Reply, decode_record, encode_record
from kitrobot.fleet.charter import charter_of
from kitrobot.fleet.host import AgentHost
from kitrobot.fleet.world import WorldHost
from kitrobot.sim.event_text import Event
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.tables.team_columns import T_ACTUATOR, T_ROLE, T_SEAT
from kitrobot.team.messages import EVERYONE, Message
from tests.fleet.bench_boards import BenchBoard

STEP = 5
LEASE = 400


@dataclass
class Faults:
    """Loss and doubling in percent, delay in ms; members of `side` hear only each other, and not their bodies if
    `bodies_too`; `stopped` do nothing, but what is sent to them waits.
    """

    loss: int = 0
    doubled: int = 0
    delay: int = 0
    side: frozenset[int] = frozenset()
    bodies_too: bool = False
    stopped: frozenset[int] = frozenset()


@dataclass
class Fleet:
    """All agents of a mission and their world; `anew` makes the run before its first step."""

    anew: Callable[[], Simulation]
    seed: int = 0
    now: int = 0
    faults: Faults = field(default_factory=Faults)
    pace: float = 1.0
    lease: int = LEASE
    boards: dict[int, BenchBoard] = field(default_factory=dict)
    """The boards that are bodies and interpreters of agents, and how long they take for a tick."""

    def __post_init__(self) -> None:
        self.random = random.Random(self.seed)
        simulation = self.anew()
        self.charter = charter_of(simulation, self.lease)
        self.world = WorldHost(simulation, self.lease, self.now, self.pace)
        self.hosts: dict[int, AgentHost] = {}
        self.lives = [0] * len(simulation.members)
        self.under_way: list[tuple[int, int, Callable[[], None]]] = []
        self.events: list[Event] = []
        self.on_step: Callable[[], None] = lambda: None
        for i in range(len(simulation.members)):
            self.start(i)

    def start(self, i: int) -> None:
        actuators = self.boards[i].actuators if i in self.boards else None
        self.hosts[i] = AgentHost(self.anew(), i, self.charter, self.lives[i], self.now, actuators)
        if self.lives[i]:
            self.world.restarted(self.now, i)
        self.lives[i] += 1

    def with_boards(self, boards: dict[int, BenchBoard]) -> None:
        """Boards take the places of simulated bodies before the first step."""
        self.boards = boards
        for i in boards:
            self.hosts[i] = AgentHost(self.anew(), i, self.charter, 0, self.now, boards[i].actuators)

    def kill(self, i: int) -> None:
        del self.hosts[i]

    @property
    def run(self) -> Simulation:
        return self.world.simulation

    def send(self, sender: int, to: int, deliver: Callable[[], None]) -> None:
        """Brings something on its way; -1 is the world."""
        faults, chance = self.faults, self.random
        inside, into = (sender in faults.side, to in faults.side)
        if inside != into and (faults.bodies_too or -1 not in (sender, to)):
            return
        if chance.randrange(100) < faults.loss:
            return
        for _ in range(2 if chance.randrange(100) < faults.doubled else 1):
            self.under_way.append((self.now + chance.randint(0, faults.delay), to, deliver))

    def step(self) -> None:
        self.now += STEP
        due = [letter for letter in self.under_way if letter[0] <= self.now and letter[1] not in self.faults.stopped]
        self.under_way = [letter for letter in self.under_way if letter not in due]
        if self.faults.delay:
            self.random.shuffle(due)
        for _, _, deliver in due:
            deliver()
        for i, host in list(self.hosts.items()):
            if i not in self.faults.stopped:
                host.time(self.now)
                self.post(i, host)
                if i in self.boards and self.now >= self.boards[i].free_at:
                    self.obeyed(i, host, self.boards[i])
        self.check_seats()
        if self.now >= self.world.due_at(self.now):
            self.world.step(self.now)
            self.events += self.world.events
            self.on_step()
        self.world.time(self.now)
        frames, self.world.frames = self.world.frames, []
        for i, frame in frames:
            data = encode_record(frame)
            self.send(-1, i, partial(self.framed, i, data))

    def check_seats(self) -> None:
        """At no moment two robots may act in one role, each as it knows the team."""
        acting: list[int] = []
        for i, host in self.hosts.items():
            table = host.replica.state.team.robots
            if table[T_ACTUATOR] and table[T_ROLE][i] >= 0 and self.now >= host.acts_from and host.may_act(self.now):
                acting.append(table[T_SEAT][i])
        assert len(acting) == len(set(acting)), acting

    def framed(self, i: int, data: bytes) -> None:
        if i not in self.hosts:
            return
        host = self.hosts[i]
        replies = host.frame(self.now, decode_record(data, Frame))
        self.post(i, host)
        for reply in replies:
            self.send(i, -1, partial(self.answered, i, encode_record(reply)))

    def obeyed(self, i: int, host: AgentHost, board: BenchBoard) -> None:
        """The board of an agent does what it was told; what came of a tick is known when it has taken its time."""
        assert host.board is not None
        for order, changes in board.done:
            if order.what == "tick":
                assert host.finish_board_tick(self.now, changes)
        board.done = []
        orders, host.board.orders = host.board.orders, []
        for order in orders:
            board.done.append((order, board.executor.do(order)))
            board.free_at = self.now + board.takes
        if board.done and not board.takes:
            self.obeyed(i, host, board)
        self.post(i, host)

    def answered(self, i: int, data: bytes) -> None:
        self.world.answer(self.now, i, decode_record(data, Reply))

    def post(self, i: int, host: AgentHost) -> None:
        replies, host.replies = host.replies, []
        for reply in replies:
            self.send(i, -1, partial(self.answered, i, encode_record(reply)))
        sendings, host.sendings = host.sendings, []
        for to, message in sendings:
            for other in range(self.charter.members) if to == EVERYONE else (to,):
                if other != i:
                    self.send(i, other, partial(self.heard, other, message))
        if host.needs_snapshot and self.random.randrange(20) == 0:
            for other in range(self.charter.members):
                if other != i:
                    self.send(i, other, partial(self.asked, other, i))

    def heard(self, i: int, message: Message) -> None:
        if i in self.hosts:
            self.hosts[i].receive(self.now, message)
            self.post(i, self.hosts[i])

    def asked(self, i: int, by: int) -> None:
        snapshot = self.hosts[i].snapshot() if i in self.hosts else None
        if snapshot is not None:
            self.send(i, by, lambda: self.hosts[by].adopt(self.now, snapshot) if by in self.hosts else None)

    def finish(self, most_ms: int = 600_000) -> None:
        end = self.now + most_ms
        while self.run.outcome is None:
            assert self.now < end, "the fleet came to no end"
            self.step()
