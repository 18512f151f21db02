"""The process of one agent: an `AgentHost`, its channel and the clock.

The process looks for its team until there is one, however long that takes, unless a limit is set. It looks anew for a
team that falls silent before the run begins. It ends when the team ends it, after `PATIENCE_S` of silence in a run, or
when the process that started it ends.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from kitrobot.fleet import envelopes as kinds
from kitrobot.fleet.body_messages import Frame, FrameError, ReplicaSnapshot, Reply, decode_record, encode_record
from kitrobot.fleet.bundles import bundle, unbundle
from kitrobot.fleet.charter import LEAST_LEASE_MS, MOST_LEASE_MS, FleetError, charter_of
from kitrobot.fleet.envelopes import EVERYBODY, TEAM_PROCESS, Envelope, EnvelopeError
from kitrobot.fleet.host import AgentHost
from kitrobot.fleet.identity import identity_of
from kitrobot.fleet.refusals import Refusals
from kitrobot.fleet.transport import Channel, milliseconds
from kitrobot.sim.simulation import Simulation
from kitrobot.team.codec import MessageError, decode
from kitrobot.text.phrases import listed
from kitrobot.text.sentences import Sentence

if TYPE_CHECKING:
    from kitrobot.fleet.board_line import BoardLine

HELLO_EVERY_MS = 200
ASK_EVERY_MS = 100
TURN_MS = 20
"""How often the host gets the time and checks every member."""
PATIENCE_S = 30.0
"""How long an agent goes on in a run without a message from its world."""
LOST_MS = 3000
"""After so long a silence before the run, the team is looked for anew; in the run, the silence is reported."""


@dataclass
class AgentBoard:
    """The board of an agent.

    Attributes:
        line: the line to it.
        actuators: the numbers of the robot's actuators that its program uses.
        is_stopped: whether it has stopped for good.
    """

    line: BoardLine
    actuators: Sequence[int]
    is_stopped: bool = False


@dataclass(frozen=True)
class RunEnd:
    """How the run ended, as the team reported it; `stopped` by the emergency stop."""

    outcome: str
    sentence: str
    stopped: bool = False


class AgentProcess:
    """Agent number `me` of a mission.

    Args:
        simulation: the mission before its first step.
        me: the agent's number.
        channel: the way to the others.
        report: called with each sentence of its log.
        is_over: called now and then whether it is to end by itself.
        board: the board that is its body and interpreter; None: its body is simulated.
        wait_s: how long it waits for the run to begin; None: for ever.
        progress: called with what it waits for.
    """

    def __init__(
        self,
        simulation: Simulation,
        me: int,
        channel: Channel,
        report: Callable[[str], None],
        is_over: Callable[[], bool],
        board: AgentBoard | None = None,
        wait_s: float | None = None,
        progress: Callable[[str], None] = lambda sentence: None,
    ) -> None:
        self.simulation = simulation
        self.me = me
        self.channel = channel
        self.report = report
        self.is_over = is_over
        self.board = board
        if board is not None:
            board.line.wake = channel.wake
        self.host: AgentHost | None = None
        self.ended: RunEnd | None = None
        self.wait_s = wait_s
        self.progress = progress
        self.identity = identity_of(simulation)
        self.began_at = self.heard_at = milliseconds()
        self.asked_at = self.timed_at = self.spoke_at = 0
        self.lease = 0
        self._refusals = Refusals()
        self._waits_for = ""
        self._silent = False

    def run(self) -> RunEnd:
        """Takes part in the run to its end.

        Raises:
            FleetError: there is no team within the limit, it does not want this agent, or it was lost.
            KitRobotError: its board is lost.
        """
        while self.ended is None:
            if self.is_over():
                return RunEnd("stopped", Sentence("whoever started this agent has ended"), True)
            self.turn()
        return self.ended

    def turn(self) -> None:
        """Handles what came, or waits a little for it, and sends what there is to send.

        Raises:
            FleetError, KitRobotError: as `run`.
        """
        self._look_for_team(milliseconds())
        came = self.channel.receive(TURN_MS / 1000)
        last = max((n for n, envelope in enumerate(came) if envelope.kind == kinds.MEMBER), default=-1)
        for number, envelope in enumerate(came):
            for stop in self.channel.stops():
                self._handle(milliseconds(), stop, False)
                self._send_pending()
            self._handle(milliseconds(), envelope, number < last)
            self._send_pending()
        if self.host is not None:
            self._read_board(milliseconds(), self.host)
            if (now := milliseconds()) - self.timed_at >= TURN_MS:
                self.timed_at = now
                self.host.time(now)
            self._send_pending()
        self._report_log()

    def _look_for_team(self, now: int) -> None:
        """Sends hello whenever there is nothing else to send to the team; gives up where there is a limit."""
        silence = now - self.heard_at
        if self.host is None:
            if self.wait_s is not None and now - self.began_at >= self.wait_s * 1000:
                raise FleetError(
                    Sentence("the run did not begin within {seconds} s", self.wait_s),
                    Sentence("start `kitrobot team` with this mission and this key, and --connect to where it listens"),
                )
            if self.channel.run and silence >= LOST_MS:
                self.channel.draw_number()
                self._wait_for(Sentence("its team is not heard any more; looks for it"))
        elif silence >= PATIENCE_S * 1000:
            raise FleetError(Sentence("the team has not been heard for {seconds} s", round(PATIENCE_S)))
        elif self._silent != (silence >= LOST_MS):
            self._silent = not self._silent
            if self._silent:
                self.report(
                    Sentence("does not hear the team's process; ends after {seconds} s of that", round(PATIENCE_S))
                )
        if now - self.spoke_at >= HELLO_EVERY_MS:
            self.spoke_at = now
            hello = [self.simulation.members[self.me].name, self.identity]
            self.channel.send(TEAM_PROCESS, kinds.HELLO, json.dumps(hello).encode())

    def _wait_for(self, what: str) -> None:
        if what != self._waits_for:
            self._waits_for = what
            self.progress(what)

    def _handle(self, now: int, envelope: Envelope, more: bool) -> None:
        """Handles an envelope; `more`: messages of the protocol follow."""
        if envelope.sender == TEAM_PROCESS:
            self.heard_at = now
            self._handle_team_message(now, envelope)
        elif self.host is not None and envelope.sender < len(self.simulation.members):
            self._handle_member_message(now, envelope, self.host, more)

    def _handle_team_message(self, now: int, envelope: Envelope) -> None:
        """Handles a message of the team's process."""
        if envelope.kind == kinds.WELCOME:
            self._welcome(envelope)
        elif envelope.kind == kinds.BEGIN and self.host is None:
            self._begin(now, envelope)
        elif envelope.kind == kinds.FRAME and self.host is not None:
            try:
                replies = self.host.frame(now, decode_record(envelope.body, Frame))
            except FrameError as error:
                self._refuse(envelope, error.args[0])
                return
            self._send_pending()
            self._reply(replies)
        elif envelope.kind == kinds.STOP:
            self._stop()
        elif envelope.kind == kinds.BYE:
            outcome, sentence = _decode_outcome(envelope.body)
            if self.host is None and outcome != "stopped":
                raise FleetError(
                    Sentence("this agent took no part in the run, which is over: {sentence}", sentence),
                    Sentence("start it again, and it waits for the next run"),
                )
            self.ended = RunEnd(outcome, sentence, outcome == "stopped")

    def _stop(self) -> None:
        """The emergency stop; it is answered only when a board is still, too."""
        if self.host is not None and not self.host.stopped:
            self.host.stop()
            if self.board is None:
                self.report(Sentence("stopped"))
        if self.host is None or self.board is None or self.board.is_stopped:
            self.channel.send(TEAM_PROCESS, kinds.STOP)

    def _read_board(self, now: int, host: AgentHost) -> None:
        """Handles the results of orders to the board."""
        if self.board is None:
            return
        for result in self.board.line.take_results():
            if result.error is not None:
                self.report(Sentence("its board is lost"))
                raise result.error
            if result.order.what == "tick" and not host.finish_board_tick(now, result.changes):
                raise FleetError(
                    Sentence("the board says what cannot be of its program"),
                    Sentence("send the program again: `kitrobot deploy … --team`"),
                )
            if result.order.what == "stop" and host.stopped and not self.board.is_stopped:
                self.board.is_stopped = True
                self.channel.send(TEAM_PROCESS, kinds.STOP)
                self.report(Sentence("stopped"))

    def _reply(self, replies: Sequence[Reply]) -> None:
        for reply in replies:
            self.spoke_at = milliseconds()
            self.channel.send(TEAM_PROCESS, kinds.REPLY, encode_record(reply))

    def _welcome(self, envelope: Envelope) -> None:
        """The answer to hello: the run, the lease and who is missing yet; or why this agent is not wanted."""
        try:
            refusal, lease, missing = json.loads(envelope.body)
            lease, missing = int(lease), [str(name)[:100] for name in missing]
        except (ValueError, TypeError):
            return
        if refusal:
            raise FleetError(Sentence("the team refused this agent: {why}", str(refusal)[:300]))
        if self.host is not None or not LEAST_LEASE_MS <= lease <= MOST_LEASE_MS:
            return
        if not self.channel.run:
            self.channel.run = envelope.run
            self.spoke_at = 0
        self.lease = lease
        if self.board is not None:
            self.board.line.set_lease(lease)
        if missing:
            self._wait_for(Sentence("is there; the team waits for {names}", listed(missing)))

    def _begin(self, now: int, envelope: Envelope) -> None:
        """The run begins; `life`: how many processes of this name took part in it before."""
        try:
            life = int(json.loads(envelope.body))
        except (ValueError, TypeError):
            return
        if self.lease and 0 <= life < 1 << 20:
            charter = charter_of(self.simulation, self.lease)
            actuators = self.board.actuators if self.board is not None else None
            self.host = AgentHost(self.simulation, self.me, charter, life, now, actuators)
            self.report(Sentence("takes part"))

    def _refuse(self, envelope: Envelope, why: Sentence) -> None:
        message = self._refusals.count(envelope.sender, why)
        if message is not None:
            self.report(message)

    def _handle_member_message(self, now: int, envelope: Envelope, host: AgentHost, more: bool) -> None:
        """Handles a message of another agent."""
        try:
            if envelope.kind == kinds.MEMBER:
                messages = [decode(one, self.channel.run) for one in unbundle(envelope.body, self.channel.me)]
                for left, message in enumerate(messages, 1 - len(messages)):
                    if message.sender.member == envelope.sender:
                        host.receive(now, message, more or left < 0)
            elif envelope.kind == kinds.SNAPSHOT_REQUEST:
                snapshot = host.snapshot()
                if snapshot is not None:
                    self.channel.send(envelope.sender, kinds.SNAPSHOT, encode_record(snapshot))
            elif envelope.kind == kinds.SNAPSHOT:
                host.adopt(now, decode_record(envelope.body, ReplicaSnapshot))
        except (MessageError, EnvelopeError, FrameError) as error:
            self._refuse(envelope, error.args[0])

    def _send_pending(self) -> None:
        """Sends the host's messages, replies and orders."""
        host = self.host
        if host is None:
            return
        sendings, host.sendings = host.sendings, []
        for to, body in bundle(sendings, self.channel.run):
            self.channel.send(to, kinds.MEMBER, body)
        replies, host.replies = host.replies, []
        self._reply(replies)
        if host.board is not None and self.board is not None:
            orders, host.board.orders = host.board.orders, []
            for order in orders:
                self.board.line.order(order)
        now = milliseconds()
        if host.needs_snapshot and now - self.asked_at >= ASK_EVERY_MS:
            self.asked_at = now
            self.channel.send(EVERYBODY, kinds.SNAPSHOT_REQUEST)

    def _report_log(self) -> None:
        refused, self.channel.refused = self.channel.refused, []
        for sentence in refused:
            self.report(sentence)
        if self.host is not None:
            log, self.host.log = self.host.log, []
            for item in log:
                if isinstance(item, Sentence):
                    self.report(item)


def _decode_outcome(body: bytes) -> tuple[str, str]:
    try:
        first, second = json.loads(body)
        return str(first)[:100], str(second)[:10_000]
    except (ValueError, TypeError):
        return "", ""
