"""Processes of a fleet in one thread: their channels meet on a bus in memory, their clocks go as the test says.

Everything but Zenoh and the clock is what ships: `TeamProcess`, `AgentProcess`, `Channel` and sealed envelopes. The
loop of the team's process waits for messages in each turn; meanwhile time passes, and the agents have their turns.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from types import SimpleNamespace
from typing import Any

from kitrobot.fleet.agent_process import AgentProcess, RunEnd
from kitrobot.fleet.charter import FleetError
from kitrobot.fleet.envelopes import TEAM_PROCESS
from kitrobot.fleet.keys import key_of
from kitrobot.fleet.team_process import FleetCallbacks, TeamProcess
from kitrobot.fleet.transport import Channel, Network
from kitrobot.sim.simulation import Simulation
from tests.fleet.network import LEASE
from tests.fleet.test_convoy import anew

KEY = key_of("a key of sixteen letters", "here")
TURN_MS = 20


class BusChannel(Channel):
    """A channel on the bus."""

    def __init__(self, bus: Bus, me: int) -> None:
        super().__init__(Network("here", ("tcp/127.0.0.1:0",)), me, KEY)
        self._session.close()
        self.bus = bus
        session: Any = SimpleNamespace(put=lambda name, data, **how: bus.put(self, name, data), close=lambda: None)
        self._session = session
        root = "kitrobot/here"
        self.names = {f"{root}/t"} if me == TEAM_PROCESS else {f"{root}/a", f"{root}/m/{me}"}

    def receive(self, seconds: float, most: int = 256) -> list[Any]:
        if self.me == TEAM_PROCESS:
            self.bus.turn()
        return super().receive(0, most)

    def take(self, data: bytes) -> None:
        self._came(SimpleNamespace(payload=data))


@dataclass
class Process:
    """An agent's process: how it ended, or why it failed."""

    agent: AgentProcess
    said: list[str]
    ended: RunEnd | None = None
    error: FleetError | None = None

    @property
    def is_there(self) -> bool:
        return self.ended is None and self.error is None


@dataclass
class Bus:
    """The network, the clock, and the processes of agents. `recorded`: all that was sent, with the name it went to."""

    now: int = 1_000_000
    channels: list[BusChannel] = field(default_factory=list)
    processes: list[Process] = field(default_factory=list)
    recorded: list[tuple[str, bytes]] = field(default_factory=list)
    said: list[str] = field(default_factory=list)
    stopping: bool = False
    anew: Callable[[], Simulation] = anew
    """Makes the run of each process before its first step."""
    turns: Iterator[None] | None = None
    """What happens meanwhile: gone on with once in each turn; at its end the emergency stop is pressed."""

    def channel(self, me: int) -> BusChannel:
        self.channels.append(BusChannel(self, me))
        return self.channels[-1]

    def put(self, sender: BusChannel | None, name: str, data: bytes) -> None:
        if sender is not None:
            self.recorded.append((name, data))
        for channel in self.channels:
            if channel is not sender and name in channel.names:
                channel.take(data)

    def agent(self, me: int, wait_s: float | None = None) -> Process:
        """Starts the process of an agent."""
        said: list[str] = []
        agent = AgentProcess(self.anew(), me, self.channel(me), said.append, lambda: False, None, wait_s, said.append)
        self.processes.append(Process(agent, said))
        return self.processes[-1]

    def kill(self, process: Process) -> None:
        self.processes.remove(process)
        self.channels.remove(process.agent.channel)  # type: ignore[arg-type]

    def team(self) -> TeamProcess:
        """A new team's process, in the place of the one before."""
        self.channels = [one for one in self.channels if one.me != TEAM_PROCESS]
        self.stopping = False
        told = FleetCallbacks(self._say, lambda: self.stopping, _nothing)
        return TeamProcess(self.anew(), self.channel(TEAM_PROCESS), LEASE, 1.0, dict, told)

    def _say(self, name: str, text: str) -> None:
        self.said.append(f"{name}: {text}" if name else text)

    def turn(self) -> None:
        """A turn of the team's process."""
        self.pass_by()
        if self.turns is not None and next(self.turns, self) is self:
            self.turns, self.stopping = None, True

    def pass_by(self, turns: int = 1) -> None:
        """Time passes, and each agent has its turn."""
        for _ in range(turns):
            self.now += TURN_MS
            for process in list(self.processes):
                if process.is_there:
                    try:
                        process.agent.turn()
                        process.ended = process.agent.ended
                    except FleetError as error:
                        process.error = error

    def meanwhile(self, what: Callable[[], Iterator[None]]) -> None:
        self.turns = what()


def _nothing(run: object) -> None:
    """Steps of the world are not looked at."""
