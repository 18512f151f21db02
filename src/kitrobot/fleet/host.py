"""`AgentHost`: one agent of a fleet, without sockets and clocks: what came and the time in, envelopes out.

It holds the agent's machine, its member of the protocol, and a replica of the team's agreed state. A tick is made for
each frame of the body, and only while the robot may act: the right ends a lease after a quorum was heard last, and a
robot that takes a role over waits until the one before it has lost its own (docs/team-protocol.md). A robot whose body
is not heard for a lease is silent in the team too: a robot without a body cannot play a role. Nor can one whose board
has been at a tick for a lease.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence

from kitrobot.fleet import notes
from kitrobot.fleet.board_body import BoardBody
from kitrobot.fleet.body_messages import MOST_SLOTS, WINDOW, Frame, ReplicaSnapshot, Reply
from kitrobot.fleet.refusals import Refusals
from kitrobot.fleet.replica import Replica
from kitrobot.fleet.replication import LogReplication
from kitrobot.fleet.team_devices import TeamDevices
from kitrobot.fleet.tick_runner import Tick, TickRunner
from kitrobot.sim.event_text import Event
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.tables.team_columns import T_ROLE
from kitrobot.team.changes import AppliedNote, Change, LogGap, NewView, QuorumChange, Refusal, SlotDecision
from kitrobot.team.charter import Charter
from kitrobot.team.commands import Note, Seat
from kitrobot.team.events import Event as Input
from kitrobot.team.events import IncomingMessage, Time, Write
from kitrobot.team.member import step
from kitrobot.team.messages import Message, OutgoingMessage
from kitrobot.team.shared_store import FIRST_STAMP
from kitrobot.team.state import Member, initial_state, may_act
from kitrobot.text.sentences import Sentence

MOST_PENDING = 12
"""Notes of this agent that are in the protocol at the same time; others wait here."""


class AgentHost:
    """Robot number `me` of a run.

    Args:
        simulation: the whole mission before its first step; this host alone uses it.
        me: the agent's number.
        charter: that of the fleet (see `charter_of`).
        life: how often this agent was started before in this run.
        now: ms by the clock that all its methods are given.
        board: the numbers of the actuators that its program uses on a board, which is its body and interpreter; None:
            its body is simulated.

    Attributes:
        sendings: what is to be sent to members, `log`: what is to be reported, `replies`: what the world is to be
            answered, since somebody took it out.
        needs_snapshot: whether to request a replica from a member that knows more.
    """

    def __init__(
        self,
        simulation: Simulation,
        me: int,
        charter: Charter,
        life: int,
        now: int,
        board: Sequence[int] | None = None,
    ) -> None:
        self.replica = Replica(simulation)
        self.me = me
        self.charter = charter
        self.machine = simulation.members[me].machine
        self.team_devices = TeamDevices(self.replica, me)
        self.state: Member = initial_state(charter, Seat(me, life), now)
        self.replication = LogReplication(self.replica, simulation.state.shared)
        self.sendings: list[OutgoingMessage] = []
        self.log: list[Event | Sentence] = []
        self.replies: list[Reply] = []
        self.needs_snapshot = False
        self.muted = False
        self.stopped = False
        self.body_heard_at = now
        self.acts_from = now
        self._serial_ticked = -1
        self._replies: dict[int, Reply] = {}
        self._early: dict[int, Frame] = {}
        self._serial = life << 32
        self._unsent: deque[Note] = deque()
        self._freeing: set[tuple[int, int, int]] = set()
        self._beginning = 0
        self._units: dict[tuple[int, int, int], int] = {}
        self._effects: list[AppliedNote | NewView] = []
        self._end_reported = -1
        """The epoch in which it reported the end of its program."""
        self.board = BoardBody(self.machine, board) if board is not None else None
        self._tick_runner = TickRunner(self.team_devices, self.replication)
        self._tick: Tick | None = None
        self._refusals = Refusals()

    # -- the protocol

    def receive(self, now: int, message: Message, more: bool = False) -> None:
        """Handles a message of another member; `more`: others came with it and follow."""
        if not self._is_silent(now):
            self._step(now, IncomingMessage(message, more))

    def time(self, now: int) -> None:
        """To be called at least every `Charter.beat`."""
        self._step(now, Time())
        self._units = {unit: self._units.get(unit, now) for unit in self.replica.held_units()}
        self._freeing &= set(self._units)
        if self.is_first():
            self._free_units(now)
        self._send_notes(now)
        if self.board is not None:
            self._check_board(now, self.board)

    def is_first(self) -> bool:
        """Whether it is the first of the view: who looks after leases."""
        return self.state.tables.view.seats[0] == self.state.seat

    def may_act(self, now: int) -> bool:
        """Whether the robot may act at this moment, as one of its team; in a new role it also waits for `acts_from`."""
        if self.stopped:
            return False
        if not self.replica.is_of_team(self.me):
            return True
        margin = round(self.board.trip) if self.board is not None else 0
        return may_act(self.charter, self.state, now + margin)

    def _is_silent(self, now: int) -> bool:
        """Whether it has no radio, or no body."""
        works_since = now if self._tick is None or self._tick.over else self._tick.at
        return self.muted or now - min(self.body_heard_at, works_since) >= self.charter.lease

    def _free_units(self, now: int) -> None:
        """Asks for units to be free again whose lease is over."""
        for work, robot, grant in self.replica.held_units():
            lease = self.replica.simulation.mission.team.works[work].lease or 0
            over = now - self._units.get((work, robot, grant), now) >= lease * 1000
            if lease and over and (work, robot, grant) not in self._freeing:
                self._freeing.add((work, robot, grant))
                self._note(now, notes.FREE, work, robot, epoch=grant)

    def _note(self, now: int, kind: int, first: int, second: int, epoch: int | None = None) -> None:
        """Puts a note into the log, when there is room."""
        self._serial += 1
        epoch = self.replica.epochs[self.me] if epoch is None else epoch
        self._unsent.append(Note((kind, epoch, first, second, self._serial)))
        self._send_notes(now)

    def _send_notes(self, now: int) -> None:
        while self._unsent and len(self.state.log.pending) < MOST_PENDING:
            self._step(now, self._unsent.popleft())

    def _step(self, now: int, event: Input) -> None:
        stepped = step(self.charter, self.state, now, event)
        self.state = stepped.state
        if not self._is_silent(now):
            self.sendings.extend(stepped.messages)
        for change in stepped.changes:
            self._apply_change(now, change)

    def _apply_change(self, now: int, change: Change) -> None:
        match change:
            case AppliedNote() | NewView():
                self._effects.append(change)
            case SlotDecision(slot=slot):
                effects, self._effects = tuple(self._effects), []
                self.replication.add_slot(slot, effects)
                self._follow(now)
            case LogGap(slot=slot):
                self._effects = []
                self.replication.skip_to(slot)
                self._follow(now)
            case QuorumChange(heard=heard):
                self.log.append(
                    Sentence("hears its team") if heard else Sentence("hears too few of its team, and waits")
                )
            case Refusal(member=member, why=why):
                if (message := self._refusals.count(member, why)) is not None:
                    self.log.append(message)

    def adopt(self, now: int, snapshot: ReplicaSnapshot) -> None:
        """Adopts another member's replica, after missed slots."""
        if not self.replication.is_complete and self.replication.adopt(snapshot):
            self._follow(now)

    def snapshot(self) -> ReplicaSnapshot | None:
        """The replica, for another member; None where this one misses slots itself."""
        if not self.replication.is_complete:
            return None
        return ReplicaSnapshot(self.replica.slot, tuple(map(tuple, self.replica.packed())))

    def _follow(self, now: int) -> None:
        """Applies the slots that are known, and follows what they change for this robot."""
        team = self.replica.state.team
        of_team = self.replica.is_of_team(self.me)
        role = team.robots[T_ROLE][self.me] if of_team else -1
        self.log.extend(self.replication.apply_known(self._confirm_note))
        self.needs_snapshot = not self.replication.is_complete
        if self.replica.beginnings[self.me] != self._beginning:
            self._beginning = self.replica.beginnings[self.me]
            self._tick_runner.restart()
            if self.board is not None:
                self.board.begin_anew()
            self._end_reported = -1
        if of_team and team.robots[T_ROLE][self.me] not in (role, -1):
            self.acts_from = now + self.charter.hold

    def _confirm_note(self, effect: AppliedNote | NewView) -> None:
        """Confirms a note of its own that has taken effect."""
        if isinstance(effect, AppliedNote) and effect.seat == self.state.seat and len(effect.numbers) == 5:
            serial = effect.numbers[4]
            self.team_devices.waiting = {k: at for k, at in self.team_devices.waiting.items() if at != serial}

    # -- the body

    def frame(self, now: int, frame: Frame) -> list[Reply]:
        """Handles the readings of the body; returns the answers to them, and to early ones that follow."""
        self.body_heard_at = now
        self.muted = frame.muted
        if self._serial_ticked < 0:
            self._serial_ticked = frame.first - 1
        if frame.serial <= self._serial_ticked:
            return [self._replies[frame.serial]] if frame.serial in self._replies else []
        if frame.serial <= self._serial_ticked + WINDOW:
            self._early[frame.serial] = frame
        return self._answer_frames(now)

    def _answer_frames(self, now: int) -> list[Reply]:
        """The answers to the frames that follow, as far as no board is at work for one of them."""
        given = []
        while (self._tick is None or self._tick.late) and self._serial_ticked + 1 in self._early:
            self._serial_ticked += 1
            reply = self._answer(now, self._early.pop(self._serial_ticked))
            if reply is not None:
                given.append(self._cache_reply(reply))
        return given

    def _cache_reply(self, reply: Reply) -> Reply:
        self._replies[reply.serial] = reply
        self._replies.pop(reply.serial - WINDOW, None)
        return reply

    def _answer(self, now: int, frame: Frame) -> Reply | None:
        """The answer to the next frame; None while a board is at work for it."""
        tick = self._tick
        if tick is not None:
            if not tick.over:
                return self._reply(now, frame, False)
            self._tick = None
            return self._reply(now, frame, False, tick)
        held = not (frame.down or self.may_act(now))
        if held or frame.down or now < self.acts_from:
            return self._reply(now, frame, held)
        runner = self._tick_runner
        written = {one.variable: one.value for one in self.state.store.entries if one.stamp != FIRST_STAMP}
        runner.sense(frame if self.board is None else None, written)
        tick = Tick(frame, self.replica.epochs[self.me], self._beginning, now, self.machine.snapshot())
        over = runner.is_over()
        if self.board is None or over:
            if not over:
                self.machine.tick()
            self._finish(now, tick, not over)
            return self._reply(now, frame, False, tick)
        self._tick = tick
        self.board.tick(now, runner.team_inputs(), [cell for _, cell in runner.shared])
        return None

    def _finish(self, now: int, tick: Tick, ticked: bool) -> None:
        """What came of a tick; commands to the team go into the log, and written variables are sent to all."""
        out, requests = self._tick_runner.commands(tick.frame.serial) if ticked else ((), [])
        for k, request in requests:
            self.team_devices.waiting[k] = self._serial + 1
            self._note(now, *request)
        epoch = self.replica.epochs[self.me]
        if self.machine.ended and not self.team_devices.has_ended() and self._end_reported != epoch:
            self._end_reported = epoch
            self._note(now, notes.END, 0, 0)
        written = self._tick_runner.changed_variables()
        for variable, value in written:
            self._step(now, Write(variable, value))
        result, quiet = self._tick_runner.result_of(out, written, tick)
        tick.result = result, written, quiet

    def _reply(self, now: int, frame: Frame, held: bool, tick: Tick | None = None) -> Reply:
        """The answer to a frame, with what came of a tick, if there was one."""
        ticked, quiet = None, self.board is None
        writes: tuple[tuple[int, int], ...] = ()
        epoch = self.replica.epochs[self.me]
        if tick is not None:
            epoch = tick.epoch
            if tick.result is not None:
                ticked, writes, quiet = tick.result
        waits = frame.down or now < self.acts_from
        first, slots = self.replication.slots_since(frame.known, MOST_SLOTS)
        return Reply(
            frame.serial,
            epoch,
            held,
            quiet and not waits and not self.team_devices.waiting,
            ticked,
            writes,
            first,
            slots,
            self.snapshot() if first < 0 else None,
        )

    # -- the board

    def finish_board_tick(self, now: int, changes: Sequence[tuple[int, int]]) -> bool:
        """Finishes a tick of the board; False when its answer cannot be of its program."""
        tick, board = self._tick, self.board
        assert tick is not None
        assert board is not None
        if not board.ticked(now, changes):
            return False
        tick.over = True
        if tick.beginning == self._beginning:
            self._finish(now, tick, True)
        if not tick.late:
            self._tick = None
            self.replies.append(self._cache_reply(self._reply(now, tick.frame, False, tick)))
        self.replies += self._answer_frames(now)
        return True

    def _check_board(self, now: int, board: BoardBody) -> None:
        """Answers for a board that takes long: its body is there. The result of the tick is sent later."""
        tick = self._tick
        if tick is not None and not tick.late and now - tick.at >= self.charter.lease // 4:
            tick.late = True
            self.replies.append(self._cache_reply(self._reply(now, tick.frame, False)))
            self.replies += self._answer_frames(now)
        board.rest(now)

    def stop(self) -> None:
        """The emergency stop: the robot does not act any more in this run."""
        self.stopped = True
        if self.board is not None:
            self.board.stop()
