"""The process that watches over a fleet: it has the world of the simulated bodies, starts the agents, and ends them.

It is no member of the team and decides nothing in it. It sends each agent its life and the start of the run, sends
readings and takes commands, records the trace, and reports what happens. With it the run is over: it ends whatever it
started, whichever way it ends itself.
"""

from __future__ import annotations

import json
import secrets
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from kitrobot.fleet import envelopes as kinds
from kitrobot.fleet.body_messages import FrameError, Reply, decode_record, encode_record
from kitrobot.fleet.charter import FleetError, charter_of
from kitrobot.fleet.envelopes import EVERYBODY, Envelope
from kitrobot.fleet.identity import identity_of
from kitrobot.fleet.refusals import Refusals
from kitrobot.fleet.roster import Answer, Roster
from kitrobot.fleet.transport import Channel, milliseconds
from kitrobot.fleet.world import WorldHost
from kitrobot.sim.outcome import Outcome
from kitrobot.sim.simulation import Simulation
from kitrobot.text.phrases import listed
from kitrobot.text.sentences import Sentence

TURN_MS = 10
"""How often the world gets the time when nothing comes."""
STOP_AGAIN_MS = 20
STOP_WITHIN_MS = 2000
"""How long the emergency stop is repeated to agents that have not answered it."""
STOPPED = "stopped"
LEAST_SILENCE_MS = 1000
"""How long an agent that says hello may be silent at least; it does so each 200 ms."""


@dataclass(frozen=True)
class FleetRun:
    """What came of a run of a fleet.

    Attributes:
        outcome: of the run in the simulator's words, or `stopped`.
        sentence: why it ended.
        slots: how many decisions its log has.
        units: for each work of the team, how many of its units are done.
        stopped_ms: after the emergency stop, when each agent confirmed that it is still, by name.
    """

    outcome: Outcome | str
    sentence: str
    slots: int
    units: dict[str, int]
    stopped_ms: dict[str, int]


@dataclass(frozen=True)
class FleetCallbacks:
    """Callbacks for the events of a fleet, in the thread that runs it.

    Attributes:
        on_message: the name of an agent, or "", and each sentence of the log.
        is_over: called often whether the emergency stop was pressed.
        on_step: the run, after the first readings and after each step.
        on_there: the name of an agent that has come.
        on_ended: once, the name of an agent whose process has ended, and a sentence; None: as `on_message`.
        stop_sentence: why the team was stopped.
    """

    on_message: Callable[[str, str], None]
    is_over: Callable[[], bool]
    on_step: Callable[[Simulation], None]
    on_there: Callable[[str], None] = lambda name: None
    on_ended: Callable[[str, str], None] | None = None
    stop_sentence: Callable[[], str] = lambda: Sentence("Stopped by the emergency stop.")


class TeamProcess:
    """A fleet of all agents of a mission.

    Args:
        simulation: the mission before its first step.
        channel: the way to the agents.
        lease_ms: how long silence is borne.
        pace: simulated time against real time; 0: as fast as agents answer.
        has_ended: the names of agents whose processes this one started and that have ended, with their statuses.
        callbacks: called with its events.
    """

    def __init__(
        self,
        simulation: Simulation,
        channel: Channel,
        lease_ms: int,
        pace: float,
        has_ended: Callable[[], dict[str, int]],
        callbacks: FleetCallbacks,
    ) -> None:
        charter_of(simulation, lease_ms)
        self.simulation = simulation
        self.channel = channel
        self.lease, self.pace = lease_ms, pace
        self.has_ended, self.callbacks = has_ended, callbacks
        self.identity = identity_of(simulation)
        self.names = [agent.name for agent in simulation.members]
        self.roster = Roster(len(self.names), max(lease_ms, LEAST_SILENCE_MS))
        self.channel.run = 1 + secrets.randbelow((1 << 63) - 1)
        self.world: WorldHost | None = None
        self.stopped_ms: dict[str, int] = {}
        self._stop_at: int | None = None
        self.begun: set[int] = set()
        """The agents that know that the run has begun."""
        self._gone: set[str] = set()
        self._refusals = Refusals()

    # -- the beginning

    def gather(self, seconds: float | None) -> None:
        """Waits until all agents are there at the same time, and reports who is missing; None: for ever.

        Raises:
            FleetError: somebody is missing after that time, or one that this process started has ended.
        """
        end = None if seconds is None else milliseconds() + round(seconds * 1000)
        reported: list[int] | None = None
        while (missing := self.roster.missing(milliseconds())) and not self.callbacks.is_over():
            names = [self.names[i] for i in missing]
            if missing != reported:
                reported = missing
                self.callbacks.on_message("", self._waiting(missing))
            if ended := [name for name in names if name in self._gone]:
                raise FleetError(
                    Sentence("these agents did not come: {names}", listed(ended)),
                    Sentence("what they said of it is above"),
                )
            if end is not None and milliseconds() >= end:
                raise FleetError(
                    Sentence("these agents did not come within {seconds} s: {names}", seconds, listed(names)),
                    Sentence("start them with `kitrobot agent`, with this mission, this key and --connect"),
                )
            for envelope in self.channel.receive(TURN_MS / 1000):
                self._handle(milliseconds(), envelope)
            self._watch_processes()
            self._report_log()

    def _waiting(self, missing: list[int]) -> Sentence:
        """Who is there, and who is missing."""
        there = [name for i, name in enumerate(self.names) if i not in missing]
        absent = listed(self.names[i] for i in missing)
        if not there:
            return Sentence("waits for {names}", absent)
        return Sentence("waits for {names}; there: {others}", absent, listed(there))

    def _hello(self, now: int, envelope: Envelope) -> None:
        """An agent comes, or comes again: the answer names the run; with that in its hello, it has a place in it."""
        i = envelope.sender
        try:
            name, identity = json.loads(envelope.body)
        except (ValueError, TypeError):
            return
        if i >= len(self.names) or name != self.names[i] or identity != self.identity:
            why = Sentence("its mission, its world or its programs are others than those of this team")
            self._refuse_agent(envelope, str(name)[:100], why)
            return
        if envelope.run == 0:
            self._welcome(now, envelope)
            return
        answer = self.roster.hello(now, i, envelope.process, self.world is not None)
        if answer is Answer.REFUSED:
            why = Sentence("another process takes part as `{agent}`; one name is one process", name)
            self._refuse_agent(envelope, name, why)
            return
        if answer is Answer.COMES:
            self.callbacks.on_there(name)
        elif answer is Answer.REPLACES:
            self.callbacks.on_message(name, Sentence("comes anew"))
            if self.world is not None:
                self.world.restarted(now, i)
                self.begun.discard(i)
        self._welcome(now, envelope)

    def _welcome(self, now: int, envelope: Envelope) -> None:
        missing = [] if self.world is not None else [self.names[k] for k in self.roster.missing(now)]
        body = json.dumps(["", self.lease, missing]).encode()
        self.channel.send(envelope.sender, kinds.WELCOME, body, envelope.process)

    def _refuse_agent(self, envelope: Envelope, name: str, why: Sentence) -> None:
        if (message := self._refusals.count(envelope.sender, Sentence("agent {agent}: {why}", name, why))) is not None:
            self.callbacks.on_message("", message)
        self.channel.send(envelope.sender, kinds.WELCOME, json.dumps([why, 0, []]).encode(), envelope.process)

    def _send_to(self, i: int, kind: int, body: bytes) -> None:
        """To the process that takes part as agent `i`."""
        self.channel.send(i, kind, body, self.roster.places[i].process)

    # -- the run

    def run(self) -> FleetRun:
        """Lets the run go on to its end, and informs all agents of the end."""
        simulation = self.simulation
        now = milliseconds()
        self.world = world = WorldHost(simulation, self.lease, now, self.pace)
        self.callbacks.on_step(simulation)
        while simulation.outcome is None and not self._has_stopped():
            now = milliseconds()
            waited = min(TURN_MS, max(0.0, world.due_at(now) - now)) / 1000
            for envelope in self.channel.receive(waited):
                self._press_stop(milliseconds())
                self._handle(milliseconds(), envelope)
            now = milliseconds()
            self._press_stop(now)
            world.time(now)
            if self._stop_at is None and now >= world.due_at(now):
                world.step(now)
                self.callbacks.on_step(simulation)
                self._report_events()
            frames, world.frames = world.frames, []
            for i, frame in frames:
                if i not in self.begun:
                    self._send_to(i, kinds.BEGIN, json.dumps(self.roster.places[i].life).encode())
                self._send_to(i, kinds.FRAME, encode_record(frame))
            self._watch_processes()
            self._report_log()
        outcome = simulation.outcome or STOPPED
        sentence = simulation.sentence if simulation.outcome else self.callbacks.stop_sentence()
        for _ in range(3):
            self.channel.send(EVERYBODY, kinds.BYE, json.dumps([outcome, sentence]).encode())
            # What is closed at once may not be sent.
            time.sleep(0.1)
        return FleetRun(outcome, sentence, world.replica.slot, world.replica.units_done(), self.stopped_ms)

    def _handle(self, now: int, envelope: Envelope) -> None:
        i = envelope.sender
        if envelope.kind == kinds.HELLO:
            self._hello(now, envelope)
        elif not self.roster.heard(now, i, envelope.process):
            return
        elif envelope.kind == kinds.REPLY and self.world is not None:
            self.begun.add(i)
            try:
                self.world.answer(now, i, decode_record(envelope.body, Reply))
            except FrameError as error:
                if (message := self._refusals.count(i, error.args[0])) is not None:
                    self.callbacks.on_message(self.names[i], message)
        elif envelope.kind == kinds.STOP and self._stop_at is not None:
            self.stopped_ms.setdefault(self.names[i], now - self._stop_at)

    # -- the emergency stop

    def _press_stop(self, now: int) -> None:
        """Orders all agents to stop, until all have confirmed."""
        if self._stop_at is None:
            if not self.callbacks.is_over():
                return
            assert self.world is not None
            self._stop_at = self._stopped_last = now
            self.world.stop()
            self.channel.send(EVERYBODY, kinds.STOP)
        elif now - self._stopped_last >= STOP_AGAIN_MS:
            self._stopped_last = now
            self.channel.send(EVERYBODY, kinds.STOP)

    def _has_stopped(self) -> bool:
        """Whether the stop has reached all who can be reached."""
        if self._stop_at is None:
            return False
        there = {name for name in self.names if name not in self._gone}
        return there <= set(self.stopped_ms) or milliseconds() - self._stop_at >= STOP_WITHIN_MS

    # -- the log

    def _watch_processes(self) -> None:
        for name, status in self.has_ended().items():
            if name not in self._gone:
                self._gone.add(name)
                (self.callbacks.on_ended or self.callbacks.on_message)(
                    name, Sentence("its process has ended (status {status})", status)
                )

    def _report_events(self) -> None:
        assert self.world is not None
        for event in self.world.events:
            if event.kind not in ("load", "unload", "collision"):
                self.callbacks.on_message(event.agent, event.text)

    def _report_log(self) -> None:
        for stranger in self.channel.strangers:
            # Of another version, it cannot read this, and says so to whoever started it.
            self.channel.send(stranger, kinds.WELCOME)
        self.channel.strangers.clear()
        messages: list[Any] = self.channel.refused
        self.channel.refused = []
        if self.world is not None:
            messages, self.world.log = messages + self.world.log, []
        for sentence in messages:
            self.callbacks.on_message("", sentence)
