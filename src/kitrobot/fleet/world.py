"""`WorldHost`: the world in which the simulated bodies of a fleet are, without sockets and clocks.

It sends each agent the readings of its body and takes its commands; it is no member of the team and decides nothing.
Its knowledge of the team comes with the answers of agents. A body stops when its agent is not heard for a lease, or
says that it may not act; a command counts only where its agent has not been missed since (`Reply.epoch`), so that an
agent that comes back with an old command moves nothing.

A step is made when every agent has answered, or when the time of the step, or the patience with the slowest, is over.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from msgspec.structs import replace

from kitrobot.fleet.body_messages import WINDOW, Frame, Reply
from kitrobot.fleet.quiescence import QuiescenceDetector
from kitrobot.fleet.replica import Replica
from kitrobot.fleet.replication import LogReplication
from kitrobot.mission.trial import FailureKind
from kitrobot.sim.event_text import Event
from kitrobot.sim.host_step import TickResult, begin_hosted_step, finish_hosted_step, fits, report_write
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.step.fault_injection import AWAY, HELD
from kitrobot.sim.tables.columns import (
    CAUSE,
    DOWN,
    ENDED,
    EVENTS,
    MUTED,
    PERIOD,
    REVIVALS,
    SAVED_TARGET,
    STUCK,
    TICK,
    WELL,
)
from kitrobot.text.sentences import Sentence

AGAIN_MS = 40
"""How long an answer is waited for before the frame is sent once more."""
PATIENCE_MS = 60
"""How long a step waits for the slowest agent."""
START_MS = 5000
"""How long the first step waits for agents that do not hear enough of their team yet."""


@dataclass(slots=True)
class AgentLink:
    """An agent as its body knows it.

    Attributes:
        asked_at: since when an answer is waited for without one.
        serial: the number of the last frame.
        waiting: frames without an answer that was taken, in their order; early: answers to others than the first.
        sent: when each of these was sent last, and again: those that were sent more than once.
        trip: how long an answer takes, ms; -1: not known yet.
        ticked: what came of its ticks and is not in the tables, with the numbers of the frames.
        answered: the last frame whose answer was taken.
        taken: the last frame of which the commands are in the tables.
        lost, harmed: whether its agent is away or may not act, and whether the body was stopped for that.
        cause: which of both (`AWAY`, `HELD`).
        beginning: how often its program had been begun anew before.
    """

    heard_at: int
    asked_at: int = 0
    serial: int = 0
    waiting: dict[int, Frame] = field(default_factory=dict)
    early: dict[int, Reply] = field(default_factory=dict)
    sent: dict[int, int] = field(default_factory=dict)
    again: set[int] = field(default_factory=set)
    trip: float = -1.0
    ticked: list[tuple[int, TickResult]] = field(default_factory=list)
    answered: int = 0
    taken: int = 0
    quiet: bool = False
    lost: bool = False
    harmed: bool = False
    cause: int = AWAY
    beginning: int = 0

    @property
    def first(self) -> int:
        """The oldest frame without an answer; the next one where there is none."""
        return next(iter(self.waiting), self.serial + 1)

    def timed(self, ms: int) -> None:
        """An answer took so long. One that had to wait for an earlier frame shows little of the way, so short ones
        count at once, longer ones slowly: else each loss would make the patience with the next one longer.
        """
        if self.trip < 0 or ms < self.trip:
            self.trip = ms
        else:
            self.trip += (ms - self.trip) / 64

    def next_ticks(self) -> list[TickResult]:
        """What is put into the tables with the next step: the next tick with commands, and those before it."""
        count = next((n for n, (_, one) in enumerate(self.ticked, 1) if one.out), len(self.ticked))
        taken, self.ticked = self.ticked[:count], self.ticked[count:]
        self.taken = taken[-1][0] if self.ticked else self.answered
        return [one for _, one in taken]


class WorldHost:
    """The bodies of all agents of a run.

    Args:
        simulation: the mission before its first step; this host alone uses it.
        lease_ms: how long an agent may be silent before its body stops.
        now: ms by the clock that all its methods are given.
        pace: simulated time against that clock; 0: each step is made as soon as all have answered.

    Attributes:
        frames: what is to be sent, each with the number of the agent.
        events: what happened in the last step; `log`: what else is to be reported, since somebody took it out.
    """

    def __init__(self, simulation: Simulation, lease_ms: int, now: int, pace: float = 1.0) -> None:
        self.simulation = simulation
        self.replica = Replica(simulation)
        self.replication = LogReplication(self.replica, simulation.state.shared)
        self.lease = lease_ms
        self.links = [AgentLink(heard_at=now) for _ in simulation.members]
        self.frames: list[tuple[int, Frame]] = []
        self.events: list[Event] = []
        self.log: list[Sentence] = []
        self._happened: list[Event] = []
        self._due: set[int] = set()
        self._quiescence = QuiescenceDetector(self.replica, now)
        self._expected = 0
        self._step_ms = simulation.tick_ms / pace if pace > 0 else 0.0
        self._stepped_at = float(now)
        self._sense(now)

    # -- answers

    def answer(self, now: int, robot: int, reply: Reply) -> None:
        """Handles an answer of an agent."""
        link = self.links[robot]
        self._apply_log(reply)
        if reply.serial not in link.waiting:
            return
        if reply.serial not in link.early and reply.serial not in link.again:
            link.timed(now - link.sent[reply.serial])
        link.early[reply.serial] = reply
        while link.first in link.early:
            first = link.first
            if not self._accept(now, robot, link.early.pop(first)):
                return
            link.waiting.pop(first, None)
            link.sent.pop(first, None)
            link.again.discard(first)
            link.answered = first

    def _accept(self, now: int, robot: int, reply: Reply) -> bool:
        """The answer to the oldest frame; False where the run has not begun, and the frame is to be sent again."""
        link = self.links[robot]
        link.heard_at, link.quiet = now, reply.quiet
        if reply.held and self.simulation.tick == 0 and not link.lost:
            link.serial += 1
            link.waiting = {link.serial: replace(link.waiting[reply.serial], serial=link.serial)}
            link.sent, link.again = {link.serial: now}, set()
            return False
        if reply.held:
            self._stop_body(robot, HELD)
            return True
        if self.replica.epochs[robot] != reply.epoch:
            return True
        self._restart_body(robot)
        if reply.ticked is not None:
            ticked = TickResult(*reply.ticked)
            if not fits(self.simulation, robot, ticked):
                self.log.append(Sentence("{agent} sent what cannot be of its machine", self._name(robot)))
                return True
            link.ticked.append((reply.serial, ticked))
        shared = len(self.simulation.state.shared.ints[0])
        for variable, value in reply.writes[:shared]:
            if 0 <= variable < shared:
                report_write(self.simulation, robot, variable, value)
        return True

    def _apply_log(self, reply: Reply) -> None:
        """Applies the part of the log that an answer contains."""
        replication = self.replication
        if reply.snapshot is not None and reply.snapshot.slot > self.replica.slot:
            replication.adopt(reply.snapshot)
        for slot, effects in enumerate(reply.slots, max(0, reply.first)):
            replication.add_slot(slot, effects)
        self._happened += replication.apply_known(lambda effect: None)

    # -- steps

    def due_at(self, now: int) -> float:
        """When the next step is to be made, as far as it is known now.

        The first one waits longer, until agents hear one another. Nobody waits for who is further behind: that is the
        way to it, not the agent.
        """
        if not any(len(self.links[i].waiting) == 1 and not self.links[i].lost for i in self._due):
            return self._stepped_at + self._step_ms
        return self._stepped_at + (START_MS if self.simulation.tick == 0 else max(self._step_ms, PATIENCE_MS))

    def step(self, now: int) -> None:
        """A step of the world with what was answered, and the readings after it."""
        simulation = self.simulation
        behind = now - self._stepped_at - self._step_ms
        self._stepped_at = now if behind > self._step_ms else self._stepped_at + self._step_ms
        ticked = {i: link.next_ticks() for i, link in enumerate(self.links)}
        finish_hosted_step(simulation, ticked)
        self._sense(now)
        simulation.events = self.events = [*simulation.happened(), *self._happened]
        simulation.state.clock[EVENTS] = 0
        self._happened = []
        self._count_expected()
        self._check_quiescence(now)
        simulation.update_outcome()

    def _check_quiescence(self, now: int) -> None:
        state = self.simulation.state
        ended, down = (state.robots.ints[row] for row in (ENDED, DOWN))
        quiet = [None if link.lost or ended[i] or down[i] != WELL else link.quiet for i, link in enumerate(self.links)]
        message = self._quiescence.check(now, bool(self.events), quiet, self._expected)
        if message is not None:
            self.log.append(message)
        if self._quiescence.is_stuck:
            state.clock[STUCK] = 1

    def _count_expected(self) -> None:
        """The run goes on for robots that are away as long as their team has not missed them."""
        lives = self.replica.lives
        expected = sum(link.lost and lives[i] >= 0 for i, link in enumerate(self.links))
        self.simulation.state.clock[REVIVALS] += expected - self._expected
        self._expected = expected

    def _sense(self, now: int) -> None:
        """What sensors measure, and a frame for each agent whose tick it is and that has answered its last one."""
        state = self.simulation.state
        begin_hosted_step(self.simulation)
        ints = state.robots.ints
        step = state.clock[TICK]
        self._due = {i for i in range(len(self.links)) if step % ints[PERIOD][i] == 0}
        for i in self._due:
            link = self.links[i]
            if len(link.waiting) >= (1 if link.lost or step == 0 else WINDOW):
                continue
            inputs = self.simulation.members[i].machine.layout.inputs
            cells = state.machines.cells[i]
            down = ints[DOWN][i] != WELL and not link.harmed and not ints[ENDED][i]
            radio = bool(ints[MUTED][i]) or down
            first = link.first
            if not link.waiting:
                link.asked_at = now
            link.serial += 1
            link.sent[link.serial] = now
            link.waiting[link.serial] = frame = Frame(
                link.serial, self.replica.slot, radio, down, tuple(cells[1 : 1 + inputs]), link.taken, first
            )
            self.frames.append((i, frame))

    def time(self, now: int) -> None:
        """Sends again what was not answered, and stops the bodies of agents that are away."""
        for i, link in enumerate(self.links):
            if not link.waiting:
                continue
            first = link.first
            for serial, frame in link.waiting.items():
                if serial not in link.early and now - link.sent[serial] >= AGAIN_MS + 2 * max(0.0, link.trip):
                    link.sent[serial] = now
                    link.again.add(serial)
                    self.frames.append((i, replace(frame, first=first)))
                if link.lost:
                    break
            if now - max(link.heard_at, link.asked_at) >= self.lease:
                self._stop_body(i, AWAY)

    def _stop_body(self, robot: int, cause: int) -> None:
        """The body stops until its agent is back and may act: which of both is missing may change meanwhile."""
        link = self.links[robot]
        if link.lost and link.cause == cause:
            return
        link.cause = cause
        why = Sentence("does not answer") if cause == AWAY else Sentence("hears too few of its team")
        self.log.append(Sentence("{agent}: {what}; its body stands still", self._name(robot), why))
        ints = self.simulation.state.robots.ints
        if not link.lost:
            link.lost, link.beginning = True, self.replica.beginnings[robot]
            link.harmed = ints[DOWN][robot] == WELL
            if link.harmed:
                self._apply_failure(robot, FailureKind.FAIL)
        elif link.harmed:
            ints[CAUSE][robot] = cause

    def _restart_body(self, robot: int) -> None:
        link = self.links[robot]
        if link.lost:
            link.lost = False
            self.log.append(Sentence("{agent} is back", self._name(robot)))
            if link.harmed:
                link.harmed = False
                if self.replica.beginnings[robot] != link.beginning:
                    self.simulation.state.robots.floats[SAVED_TARGET][robot] = 0.0
                self._apply_failure(robot, FailureKind.REVIVE)

    def _apply_failure(self, robot: int, kind: FailureKind) -> None:
        self._count_expected()
        self.simulation.inject_fault(self._name(robot), kind, self.links[robot].cause)

    def restarted(self, now: int, robot: int) -> None:
        """The agent has a new process, which begins with the next frame."""
        link = self.links[robot]
        frame = next(reversed(link.waiting.values()), None)
        link.waiting, link.early, link.ticked = {}, {}, []
        if frame is not None:
            link.serial += 1
            link.waiting[link.serial] = replace(frame, serial=link.serial, first=link.serial)
            link.sent, link.again = {link.serial: now}, set()

    def stop(self) -> None:
        """The emergency stop: everything stands still."""
        self.simulation.stop_motors()

    def _name(self, robot: int) -> str:
        return self.simulation.members[robot].name
