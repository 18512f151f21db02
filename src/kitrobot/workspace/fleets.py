"""A mission run as a fleet: its files laid out for the processes of agents, and these started, watched and ended."""

from __future__ import annotations

import shutil
import socket
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path

from kitrobot.fleet.envelopes import TEAM_PROCESS
from kitrobot.fleet.keys import VARIABLE, find_key, key_of, new_key
from kitrobot.fleet.processes import Agents
from kitrobot.fleet.team_process import FleetCallbacks, FleetRun, TeamProcess
from kitrobot.fleet.transport import Channel, Network
from kitrobot.sim.simulation import Simulation
from kitrobot.text.sentences import Sentence
from kitrobot.trace.model import TraceHeader
from kitrobot.workspace.mission_loader import OpenMission
from kitrobot.workspace.traces import lay_out

DRIVERS = "*.driver.py"


@dataclass(frozen=True)
class FleetPlan:
    """Who is started, and how the processes of a fleet find each other.

    Attributes:
        file: the mission's file, which every agent that is started here reads.
        names: the agents that are started here.
        network: of the team's process.
        key: a file with the team's key; None: one is made for this run.
        boards: the ports of agents that are real robots.
        lease_ms: how long silence is borne.
        pace: simulated time against real time; 0: as fast as agents answer.
        wait_s: how long agents may take to come; None: as long as they need.
    """

    file: Path
    names: Sequence[str]
    network: Network
    key: Path | None = None
    boards: Mapping[str, str] = field(default_factory=dict)
    lease_ms: int = 500
    pace: float = 1.0
    wait_s: float | None = None

    def words(self, name: str) -> list[str]:
        """The command line of an agent."""
        network = self.network
        words = ["agent", str(self.file), "--as", name, "--with-input", "--fleet", network.fleet]
        where = network.connect or network.listen
        words += [word for at in where for word in ("--router" if network.router else "--connect", at)]
        words += ["--board", self.boards[name]] if name in self.boards else []
        words += ["--key", str(self.key)] if self.key is not None else []
        words += ["--tls", str(network.tls)] if network.tls is not None else []
        return words


def run_fleet(simulation: Simulation, plan: FleetPlan, agents: Agents, callbacks: FleetCallbacks) -> FleetRun:
    """Starts the agents of a plan and lets the run go on to its end.

    Raises:
        FleetError: the network cannot be opened, or an agent does not come.
    """
    made = new_key()
    secret = key_of(made, VARIABLE) if plan.key is None else find_key(plan.key)
    assert secret is not None, "a file has a key, or none can be read from it"

    channel = Channel(plan.network, TEAM_PROCESS, secret)
    try:
        where = plan.network.connect or plan.network.listen
        callbacks.on_message("", Sentence("the team is at {endpoints}", ", ".join(where)))
        for name in plan.names:
            agents.start(name, plan.words(name), {VARIABLE: made} if plan.key is None else {})
        team = TeamProcess(simulation, channel, plan.lease_ms, plan.pace, agents.ended, callbacks)
        team.gather(plan.wait_s)
        if not callbacks.is_over():
            callbacks.on_message("", Sentence("all agents are there"))
        return team.run()
    finally:
        channel.close()


def files_for_agents(opened: OpenMission, header: TraceHeader, folder: Path, drivers: Path | None) -> Path:
    """Lays out what agents read: the mission as it is open, its world, its XML files, and drivers of one's own.

    Args:
        opened: the mission.
        header: of its run, which brings all of it along.
        folder: an empty one.
        drivers: the folder in which drivers of boards may lie; None: none is needed.

    Returns:
        The mission's file.

    Raises:
        FileError: a file cannot be written.
    """
    file = lay_out(header, opened.mission.world_href, Path(opened.name).stem, folder)
    for path in sorted(drivers.glob(DRIVERS)) if drivers is not None else ():
        with suppress(OSError):
            shutil.copyfile(path, folder / path.name)
    return file


def free_endpoint(tls: bool = False) -> str:
    """An endpoint on a port of this machine that nobody uses now."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return f"{'tls' if tls else 'tcp'}/127.0.0.1:{probe.getsockname()[1]}"
