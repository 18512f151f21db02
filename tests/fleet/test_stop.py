"""The emergency stop goes ahead of everything else, on every way that it takes: orders of events are shown, not times.

How many ms it takes is measured by `benchmarks.fleets`.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from threading import Event
from types import SimpleNamespace
from typing import Any

import pytest

from kitrobot.deploy.line.board import Board
from kitrobot.fleet import envelopes as kinds
from kitrobot.fleet.agent_process import AgentBoard, AgentProcess
from kitrobot.fleet.board_body import Order
from kitrobot.fleet.board_line import BoardLine
from kitrobot.fleet.body_messages import Frame, encode_record
from kitrobot.fleet.bundles import bundle
from kitrobot.fleet.envelopes import EVERYBODY, TEAM_PROCESS, Envelope, seal
from kitrobot.fleet.identity import identity_of
from kitrobot.fleet.keys import key_of
from kitrobot.fleet.team_process import FleetCallbacks, TeamProcess
from kitrobot.fleet.transport import MOST_OF_ONE, Channel, Network
from kitrobot.sim.tables.team_columns import T_AT
from kitrobot.team.commands import Seat
from kitrobot.team.messages import EVERYONE, Heartbeat, OutgoingMessage
from kitrobot_onboard.state import STATE
from tests.fleet.bench_boards import bench_boards
from tests.fleet.network import LEASE
from tests.fleet.test_convoy import anew, fleet, until
from tests.patience import PATIENCE_S

KEY = key_of("a key of sixteen letters", "here")
RUN = 7
NAMES = [f"robot-{n}" for n in range(1, 5)]


class Heard(Channel):
    """A channel of which the test is the network: what it sends is kept, what comes is put into it."""

    def __init__(self, me: int) -> None:
        super().__init__(Network("here", ("tcp/127.0.0.1:0",)), me, KEY)
        self.run = RUN
        self.sent: list[int] = []
        self.on_send: Callable[[int], None] = lambda kind: None

    def send(self, to: int, kind: int, body: bytes = b"", process: int = 0) -> None:
        self.sent.append(kind)
        super().send(to, kind, body, process)
        self.on_send(kind)

    def come(
        self,
        kind: int,
        body: bytes = b"",
        sender: int = TEAM_PROCESS,
        run: int | None = None,
        process: int | None = None,
    ) -> None:
        """From the team to this process, or from the first process of an agent, in the run that is known."""
        to = self.me if kind != kinds.STOP else EVERYBODY
        run = self.run if run is None else run
        process = (self.process if sender == TEAM_PROCESS else 1000 + sender) if process is None else process
        envelope = Envelope(kind, run, sender, to, 1, body, process)
        self._came(SimpleNamespace(payload=seal(envelope, KEY)))


@pytest.fixture
def opened() -> Iterator[Callable[[int], Heard]]:
    made: list[Heard] = []

    def channel(me: int) -> Heard:
        made.append(Heard(me))
        return made[-1]

    yield channel
    for one in made:
        one.close()


def heartbeat(member: int, stamp: int) -> bytes:
    [(_, body)] = bundle([OutgoingMessage(EVERYONE, Heartbeat(Seat(member, 0), stamp, 0, 0, True, 0, ()))], RUN)
    return body


INPUTS = anew().members[0].machine.layout.inputs


def frame(serial: int) -> bytes:
    return encode_record(Frame(serial, 0, False, False, (0,) * INPUTS))


def begun(channel: Heard, said: list[str], over: Event, board: AgentBoard | None = None) -> AgentProcess:
    """An agent that was welcome, and whose run begins with the first thing that it reads."""
    channel.come(kinds.WELCOME, json.dumps(["", LEASE, []]).encode())
    channel.come(kinds.BEGIN, b"0")
    return AgentProcess(anew(), 0, channel, said.append, over.is_set, board)


def test_a_stop_overtakes_what_waits_and_is_not_dropped_by_a_flood(opened: Callable[[int], Heard]) -> None:
    channel = opened(0)
    for serial in range(MOST_OF_ONE + 10):
        channel.come(kinds.FRAME, bytes(serial % 9))
    channel.come(kinds.STOP)
    channel.come(kinds.STOP)
    assert [one.kind for one in channel.receive(0, most=2)] == [kinds.STOP, kinds.FRAME, kinds.FRAME]
    assert kinds.STOP not in [one.kind for one in channel.receive(0, most=MOST_OF_ONE)]


def test_a_stop_of_another_run_or_key_is_refused_like_everything_of_it(opened: Callable[[int], Heard]) -> None:
    channel = opened(0)
    channel.come(kinds.STOP, run=8)
    other = seal(Envelope(kinds.STOP, RUN, TEAM_PROCESS, EVERYBODY, 1, b""), bytes(32))
    channel._came(SimpleNamespace(payload=other))
    assert channel.receive(0) == []
    assert sorted(channel.refused, key=len)[0] == "refused: a message of another run"
    assert "another key" in sorted(channel.refused, key=len)[1]


def test_an_agent_with_much_to_read_stops_before_it_reads_on(opened: Callable[[int], Heard]) -> None:
    """The stop comes while it is busy with a batch of messages that came before."""
    channel, said, over = opened(0), list[str](), Event()
    agent = begun(channel, said, over)
    for serial in range(1, 101):
        channel.come(kinds.MEMBER, heartbeat(1, serial), sender=1)
        channel.come(kinds.FRAME, frame(serial))
    answered: list[int] = []

    def sent(kind: int) -> None:
        if kind == kinds.REPLY and not answered:
            channel.come(kinds.STOP)
        if kind in (kinds.REPLY, kinds.STOP):
            answered.append(kind)
        if len(answered) >= 20:
            over.set()

    channel.on_send = sent
    agent.run()
    assert answered[:2] == [kinds.REPLY, kinds.STOP]
    assert kinds.STOP not in answered[2:]
    assert "stopped" in said
    assert agent.host is not None
    assert agent.host.stopped


def test_a_stop_ends_a_run_that_did_not_begin_for_an_agent(opened: Callable[[int], Heard]) -> None:
    channel, said, over = opened(0), list[str](), Event()
    channel.come(kinds.STOP)
    channel.on_send = lambda kind: over.set() if kind == kinds.STOP else None
    agent = AgentProcess(anew(), 0, channel, said.append, over.is_set)
    assert agent.run().stopped
    assert agent.host is None


def test_who_stands_in_a_meeting_and_is_stopped_does_nothing_when_the_meeting_ends() -> None:
    one = fleet()
    until(one, 1000)
    table = one.run.state.team.robots
    while len({table[T_AT][i] for i in range(3)}) == 1 or table[T_AT][0] < 0:
        one.step()
    stopped, meeting = one.hosts[0], table[T_AT][0]
    stopped.stop()
    machine, serial = stopped.machine.snapshot(), one.world.links[0].serial
    until(one, one.now + 4 * LEASE)
    assert stopped.replica.state.team.robots[T_AT][0] != meeting, "the meeting is over, and it knows"
    assert one.world.links[0].serial > serial, "it was asked for more ticks"
    assert stopped.machine.snapshot() == machine


def test_the_teams_process_sends_the_stop_before_it_reads_on(opened: Callable[[int], Heard]) -> None:
    channel = opened(TEAM_PROCESS)
    pressed = Event()
    told = FleetCallbacks(lambda name, sentence: None, pressed.is_set, lambda run: None)
    simulation = anew()
    team = TeamProcess(simulation, channel, LEASE, 1.0, dict, told)
    for i, name in enumerate(NAMES):
        channel.come(kinds.HELLO, json.dumps([name, identity_of(simulation)]).encode(), sender=i)
    team.gather(1)
    # All four are welcome; there is much to read, and while it is read somebody presses.
    for _ in range(50):
        for i, name in enumerate(NAMES):
            channel.come(kinds.HELLO, json.dumps([name, identity_of(simulation)]).encode(), sender=i)
    since = len(channel.sent)

    def sent(kind: int) -> None:
        if kind == kinds.STOP and not team.stopped_ms:
            for i in range(4):
                channel.come(kinds.STOP, sender=i)
        elif kind == kinds.WELCOME:
            pressed.set()

    channel.on_send = sent
    ended = team.run()
    order = channel.sent[since:]
    assert kinds.STOP in order[: order.index(kinds.WELCOME) + 3], "no second message is read before the stop is sent"
    assert kinds.FRAME not in order[order.index(kinds.STOP) :][: order.index(kinds.WELCOME) + 1]
    assert ended.outcome == "stopped"
    assert sorted(ended.stopped_ms) == NAMES


class HeldBoard(Board):
    """A board whose next tick takes until it is let go of; what is asked of it is kept, in its order."""

    def __init__(self, line: Any) -> None:
        super().__init__(line)
        self.orders: list[str] = []
        self.let_go, self.at_work = Event(), Event()

    def member_tick(self, inputs: Mapping[int, int]) -> Any:
        self.orders.append("tick")
        self.at_work.set()
        assert self.let_go.wait(PATIENCE_S)
        return super().member_tick(inputs)

    def stand_still(self) -> Any:
        self.orders.append("still")
        return super().stand_still()

    def stop(self) -> Any:
        self.orders.append("stop")
        return super().stop()


def test_a_board_stops_next_after_the_tick_that_it_is_at_whatever_it_was_told_before(tmp_path: Path) -> None:
    with bench_boards(anew(), {0: 0}, tmp_path) as boards:
        held = HeldBoard(boards[0].board.line)
        line = BoardLine(held)
        line.order(Order("tick", True))
        assert held.at_work.wait(PATIENCE_S)
        line.order(Order("still"))
        line.order(Order("tick"))
        line.order(Order("stop"))
        held.let_go.set()
        line.close()
        assert held.orders[:2] == ["tick", "stop"]
        assert set(held.orders[2:]) <= {"stop"}
        assert boards[0].bench.robot[STATE] == 1


def test_an_agent_whose_team_is_gone_stops_its_board_before_it_reads_on(
    opened: Callable[[int], Heard], tmp_path: Path
) -> None:
    """Who started it has ended (`is_over`), while its program runs on the board, and much was still to be read."""
    channel, said, over = opened(0), list[str](), Event()

    def gone(kind: int) -> None:
        if kind == kinds.MEMBER and not over.is_set():
            over.set()
            for serial in range(2, 22):
                channel.come(kinds.FRAME, frame(serial))

    channel.on_send = gone
    with bench_boards(anew(), {0: 0}, tmp_path) as boards:
        boards[0].board.begin_member()
        boards[0].board.member_tick({})
        line = BoardLine(boards[0].board)
        agent = begun(channel, said, over, AgentBoard(line, boards[0].actuators))
        assert agent.run().stopped
        line.close()
        assert boards[0].bench.robot[STATE] == 1
    assert len(channel.receive(0)) == 20


def test_a_stop_is_answered_for_a_board_when_it_stands_still_without_being_asked_again(
    opened: Callable[[int], Heard], tmp_path: Path
) -> None:
    channel, said, over = opened(0), list[str](), Event()

    def sent(kind: int) -> None:
        if kind == kinds.MEMBER and kinds.STOP not in channel.sent:
            channel.come(kinds.STOP)
        elif kind == kinds.STOP:
            over.set()

    channel.on_send = sent
    with bench_boards(anew(), {0: 0}, tmp_path) as boards:
        boards[0].board.begin_member()
        boards[0].board.member_tick({})
        line = BoardLine(boards[0].board)
        begun(channel, said, over, AgentBoard(line, boards[0].actuators)).run()
        assert boards[0].bench.robot[STATE] == 1
        line.close()
