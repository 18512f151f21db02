"""The process that watches over a fleet: it has the world of the simulated bodies, starts the agents, and ends them.

It is no member of the team and decides nothing in it. It tells each agent its life and when the run begins, sends
readings and takes commands, records the trace, and says what happens. With it the run is over: it ends whatever it
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
from kitrobot.fleet.bodies import FrameError, read_reply, write_frame
from kitrobot.fleet.charter import FleetError, charter_of
from kitrobot.fleet.envelopes import EVERYBODY, Envelope
from kitrobot.fleet.identity import identity_of
from kitrobot.fleet.transport import Channel, milliseconds
from kitrobot.fleet.world import WorldHost
from kitrobot.sim import Outcome, Simulation
from kitrobot.text import COMMA, Sentence, Series

TURN_MS = 10
"""How often the world is told the time when nothing comes."""
STOP_AGAIN_MS = 20
STOP_WITHIN_MS = 2000
"""How long the emergency stop is repeated to agents that have not answered it."""
STOPPED = "stopped"


@dataclass(frozen=True)
class FleetRun:
    """What came of a run of a fleet.

    Attributes:
        outcome: of the run in the simulator's words, or `stopped`.
        sentence: why it ended.
        slots: how many decisions its log has.
        units: for each work of the team, how many of its units are done.
        stopped_ms: after the emergency stop, when each agent that answered said that it stands still, by name.
    """

    outcome: Outcome | str
    sentence: str
    slots: int
    units: dict[str, int]
    stopped_ms: dict[str, int]


@dataclass(frozen=True)
class FleetTold:
    """Who is told of a fleet, in the thread that runs it.

    Attributes:
        say: the name of an agent, or "", and each sentence of the log.
        is_over: asked often whether the emergency stop was pressed.
        on_step: the run, after the first readings and after each step.
        on_there: the name of an agent that has come.
        on_ended: the name of an agent whose process has ended, and the sentence that says so, once; None: as `say`.
    """

    say: Callable[[str, str], None]
    is_over: Callable[[], bool]
    on_step: Callable[[Simulation], None]
    on_there: Callable[[str], None] = lambda name: None
    on_ended: Callable[[str, str], None] | None = None


class TeamProcess:
    """A fleet of all agents of a mission.

    Args:
        simulation: the mission before its first step.
        channel: the way to the agents.
        lease_ms: how long silence is borne.
        pace: simulated time against real time; 0: as fast as agents answer.
        has_ended: the names of agents whose processes this one started and that have ended, with their statuses.
        told: who is told of it.
    """

    def __init__(
        self,
        simulation: Simulation,
        channel: Channel,
        lease_ms: int,
        pace: float,
        has_ended: Callable[[], dict[str, int]],
        told: FleetTold,
    ) -> None:
        charter_of(simulation, lease_ms)
        self.simulation = simulation
        self.channel = channel
        self.lease, self.pace = lease_ms, pace
        self.has_ended, self.told = has_ended, told
        self.identity = identity_of(simulation)
        self.names = [agent.name for agent in simulation.members]
        self.lives: dict[int, int] = {}
        self.world: WorldHost | None = None
        self.stopped_ms: dict[str, int] = {}
        self._stop_at: int | None = None
        self._gone: set[str] = set()

    # -- the beginning

    def gather(self, seconds: float) -> None:
        """Waits until all agents have said hello.

        Raises:
            FleetError: somebody has not, in that time.
        """
        end = milliseconds() + round(seconds * 1000)
        while len(self.lives) < len(self.names) and not self.told.is_over():
            for envelope in self.channel.receive(TURN_MS / 1000):
                self._take(milliseconds(), envelope)
            self._watch_processes()
            self._tell()
            missing = [name for i, name in enumerate(self.names) if i not in self.lives]
            ended = [name for name in missing if name in self._gone]
            if ended or (missing and milliseconds() >= end):
                raise FleetError(
                    Sentence("these agents did not come: {names}", Series(COMMA, (ended or missing)[:10])),
                    Sentence("what they said of it is above")
                    if ended
                    else Sentence("start them with `kitrobot agent`, with this mission, this key and --connect"),
                )

    def _hello(self, now: int, envelope: Envelope) -> None:
        """An agent comes, or comes again: it is told which life it has."""
        i = envelope.sender
        try:
            name, identity = json.loads(envelope.body)
        except (ValueError, TypeError):
            return
        if i >= len(self.names) or name != self.names[i] or identity != self.identity:
            why = Sentence("its mission, its world or its programs are others than those of this team")
            self.told.say("", Sentence("refused {agent}: {why}", str(name)[:100], why))
            self.channel.send(i, kinds.WELCOME, json.dumps([why, 0, 0]).encode())
            return
        known = self.lives.get(i)
        if known is None:
            self.lives[i] = 0
            self.told.on_there(name)
        elif self.world is not None and self.world.links[i].heard_at + self.lease < now:
            self.lives[i] = known + 1
            self.world.restarted(now, i)
            self.told.say(name, Sentence("comes anew"))
        elif self.world is not None and now - self._began_at > self.lease:
            return
        self.channel.send(i, kinds.WELCOME, json.dumps(["", self.lives[i], self.lease]).encode())
        if self.world is not None:
            self.channel.send(i, kinds.BEGIN)

    # -- the run

    def run(self) -> FleetRun:
        """Lets the run go on to its end, and tells all agents that it is over."""
        simulation = self.simulation
        self.channel.run = 1 + secrets.randbelow(1 << 48)
        self._began_at = now = milliseconds()
        self.world = world = WorldHost(simulation, self.lease, now, self.pace)
        self.told.on_step(simulation)
        begun: set[int] = set()
        while simulation.outcome is None and not self._has_stopped():
            now = milliseconds()
            waited = min(TURN_MS, max(0.0, world.due_at(now) - now)) / 1000
            for envelope in self.channel.receive(waited):
                self._press_stop(milliseconds())
                self._take(milliseconds(), envelope)
                if envelope.kind == kinds.REPLY:
                    begun.add(envelope.sender)
            now = milliseconds()
            self._press_stop(now)
            world.time(now)
            if self._stop_at is None and now >= world.due_at(now):
                world.step(now)
                self.told.on_step(simulation)
                self._tell_events()
            frames, world.frames = world.frames, []
            for i, frame in frames:
                if i not in begun:
                    self.channel.send(i, kinds.BEGIN)
                self.channel.send(i, kinds.FRAME, write_frame(frame))
            self._watch_processes()
            self._tell()
        outcome = simulation.outcome or STOPPED
        sentence = simulation.sentence if simulation.outcome else Sentence("Stopped by the emergency stop.")
        for _ in range(3):
            self.channel.send(EVERYBODY, kinds.BYE, json.dumps([outcome, sentence]).encode())
            # What is closed at once may not be sent.
            time.sleep(0.1)
        return FleetRun(outcome, sentence, world.replica.slot, world.replica.units_done(), self.stopped_ms)

    def _take(self, now: int, envelope: Envelope) -> None:
        i = envelope.sender
        if envelope.kind == kinds.HELLO:
            self._hello(now, envelope)
        elif envelope.kind == kinds.REPLY and self.world is not None and i < len(self.names):
            try:
                self.world.answer(now, i, read_reply(envelope.body))
            except FrameError as error:
                self.told.say(self.names[i], Sentence("refused: {why}", error.args[0]))
        elif envelope.kind == kinds.STOP and self._stop_at is not None and i < len(self.names):
            self.stopped_ms.setdefault(self.names[i], now - self._stop_at)

    # -- the emergency stop

    def _press_stop(self, now: int) -> None:
        """Tells all agents to stop, until all have said that they did."""
        if self._stop_at is None:
            if not self.told.is_over():
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
                (self.told.on_ended or self.told.say)(name, Sentence("its process has ended (status {status})", status))

    def _tell_events(self) -> None:
        assert self.world is not None
        for event in self.world.events:
            if event.kind not in ("load", "unload", "collision"):
                self.told.say(event.agent, event.text)

    def _tell(self) -> None:
        told: list[Any] = self.channel.refused
        self.channel.refused = []
        if self.world is not None:
            told, self.world.log = told + self.world.log, []
        for sentence in told:
            self.told.say("", sentence)
