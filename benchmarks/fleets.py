"""`python -m benchmarks.fleets WHAT COUNT SECONDS`: one run of a fleet as `kitrobot team` runs it, from inside.

WHAT is `cost` (what COUNT agents take in memory and on the network while they drive, for so many seconds), `hang` (an
agent of a team of COUNT is stopped with SIGSTOP: how long until its substitute's first command), or `stop` (the
emergency stop is pressed after so many seconds: how long until each agent has said that it stands still; in
`stop-boards` two of them are boards at the end of a line). It prints the figures as JSON. Bytes are counted in a
network of its own, where nobody else's are; where that may not be made (it takes root on Linux), they are left out.
"""

from __future__ import annotations

import ctypes
import fcntl
import json
import os
import signal
import socket
import struct
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path

from kitrobot.boards.teams import agent_program
from kitrobot.fleet.identity import identity_of
from kitrobot.fleet.processes import Agents
from kitrobot.fleet.team_process import FleetCallbacks
from kitrobot.fleet.transport import Network
from kitrobot.sim.agent_views import commanded
from kitrobot.sim.simulation import Simulation
from kitrobot.workspace.fleets import FleetPlan, free_endpoint, run_fleet
from kitrobot.workspace.mission_loader import OpenMission, open_mission
from kitrobot.workspace.mission_run import RunOptions

CONVOY = Path(__file__).parents[1] / "examples/convoy"
LEASE_MS, LARGE_LEASE_MS = 500, 5000
"""The usual lease; that of a team of more than ten, whose processes have to take turns on a few cores."""
LATEST_S = 60.0
"""When a run is given up."""
CLONE_NEWNET, SIOCGIFFLAGS, SIOCSIFFLAGS, IFF_UP = 0x40000000, 0x8913, 0x8914, 1


def own_network() -> bool:
    """A network for this process and its children alone, a loopback; False where it may not be made."""
    if not sys.platform.startswith("linux") or ctypes.CDLL(None).unshare(CLONE_NEWNET) != 0:
        return False
    with socket.socket() as probe:
        name = struct.pack("16sH14s", b"lo", 0, b"")
        flags = struct.unpack("16sH14s", fcntl.ioctl(probe, SIOCGIFFLAGS, name))[1]
        fcntl.ioctl(probe, SIOCSIFFLAGS, struct.pack("16sH14s", b"lo", flags | IFF_UP, b""))
    return True


def mission(count: int, folder: Path) -> Path:
    """The convoy with so many robots, in a room that is large enough; those beyond four are spare. Nobody fails."""
    text = (CONVOY / "convoy.krt").read_text(encoding="utf-8")
    world = (CONVOY / "convoy.world.xml").read_text(encoding="utf-8")
    agent = '    <agent name="robot-{n}" program="convoy" robot="mini-robot"/>\n'
    more = range(5, count + 1)
    before = agent.format(n=4)
    assert before in text
    text = text.replace(before, before + "".join(agent.format(n=n) for n in more))
    text = text.replace('  <failure agent="robot-2" at="3" kind="fail"/>\n', "").replace("convoy.world", "wide.world")
    starts = "".join(
        f'  <start name="robot-{n}" x="{3000 + 300 * (n % 8)}" y="{300 + 200 * (n // 8)}" heading="0"/>\n' for n in more
    )
    world = world.replace("</world>", starts + "</world>").replace('width="2600"', 'width="6000"')
    for least in range(4, count, -1):
        text = text.replace(agent.format(n=least), "")
    (folder / "wide.world.xml").write_text(world, encoding="utf-8")
    for driver in ("turn", "drive", "lamp"):
        # A board on this computer has drivers of its own; that there are some is looked for here.
        (folder / f"{driver}.driver.py").write_text("def make(settings):\n    raise OSError\n", encoding="utf-8")
    file = folder / "wide.krt"
    file.write_text(text, encoding="utf-8")
    return file


@contextmanager
def boards_of(opened: OpenMission) -> Iterator[dict[str, str]]:
    """Boards with the programs of two agents, each on CPython in a process of its own; the addresses of their lines."""
    from tests.boards.host import board_with

    with ExitStack() as stack:
        yield {
            name: stack.enter_context(board_with(agent_program(opened, name).file.to_bytes())).address
            for name in ("robot-2", "robot-3")
        }


class FleetMeasurement:
    """A run of a fleet that is looked at after each step, and stopped when what is wanted is known."""

    def __init__(self, what: str, count: int, seconds: float) -> None:
        self.what, self.count, self.seconds = what, count, seconds
        self.agents = Agents(lambda name, told: None)
        self.over = False
        self.figures: dict[str, object] = {}
        self.began = self.at = 0.0
        self.bytes = 0
        self.stopped = self.taken_over = ""

    def run(self) -> dict[str, object]:
        counted = own_network()
        with tempfile.TemporaryDirectory() as folder:
            file = mission(self.count, Path(folder))
            opened = open_mission(file)
            simulation = opened.prepare(RunOptions()).simulation
            names = [agent.name for agent in simulation.members]
            network = Network(identity_of(simulation), (free_endpoint(),))
            lease = LEASE_MS if self.count <= 10 else LARGE_LEASE_MS
            with ExitStack() as stack:
                boards = stack.enter_context(boards_of(opened)) if self.what == "stop-boards" else {}
                plan = FleetPlan(file, names, network, boards=boards, lease_ms=lease, pace=1.0)
                stack.enter_context(self.agents)
                told = FleetCallbacks(lambda name, said: None, lambda: self.over, self.look)
                ended = run_fleet(simulation, plan, self.agents, told)
            if self.what.startswith("stop"):
                self.figures = {
                    "stopped_ms": [ms for name, ms in ended.stopped_ms.items() if name not in boards],
                    "boards_ms": [ms for name, ms in ended.stopped_ms.items() if name in boards],
                    "silent": len(names) - len(ended.stopped_ms),
                }
        if not counted:
            self.figures.pop("bytes_s", None)
        return self.figures

    def look(self, run: Simulation) -> None:
        now = time.monotonic()
        self.began = self.began or now
        self.over = self.over or now - self.began > LATEST_S
        {"cost": self.cost, "hang": self.hang}.get(self.what, self.stop)(run, now)

    def stop(self, run: Simulation, now: float) -> None:
        """Pressed while all drive."""
        self.over = self.over or now - self.began >= self.seconds

    def cost(self, run: Simulation, now: float) -> None:
        """When all have found one another."""
        if not self.at and now - self.began >= min(2.0, self.seconds):
            self.at, self.bytes = now, network_bytes()
        elif self.at and not self.figures and now - self.at >= self.seconds:
            pids = [process.pid for process in self.agents.processes.values()]
            self.figures = {
                "bytes_s": (network_bytes() - self.bytes) / (now - self.at) / len(pids),
                "pss_mb": [memory_mb(pid, "Pss") for pid in pids],
                "rss_mb": [memory_mb(pid, "Rss") for pid in pids],
                "ticks_s": run.tick / (now - self.began),
            }
            self.over = True

    def hang(self, run: Simulation, now: float) -> None:
        """The robot that plays a role and drives is stopped after three seconds."""
        by = commanded(run.state)
        if not self.stopped and now - self.began >= 3:
            self.stopped, self.at = "robot-2", now
            os.kill(self.agents.processes["robot-2"].pid, signal.SIGSTOP)
        for event in run.events:
            if self.stopped and event.text == f"takes over for {self.stopped}":
                self.taken_over = event.agent
                self.figures["taken_over_ms"] = 1000 * (now - self.at)
        if self.taken_over and not self.over and any(run.members[i].name == self.taken_over for i in by):
            self.figures["commands_ms"] = 1000 * (now - self.at)
            self.over = True


def network_bytes() -> int:
    """All that went over the loopback."""
    line = next(one for one in Path("/proc/net/dev").read_text().splitlines() if one.strip().startswith("lo:"))
    return int(line.split(":")[1].split()[0])


def memory_mb(pid: int, kind: str) -> float:
    """The memory of a process: `Rss` all, `Pss` with what it shares counted in parts; 0 where nobody knows."""
    try:
        lines = Path(f"/proc/{pid}/smaps_rollup").read_text().splitlines()
    except OSError:
        return 0.0
    return next((int(line.split()[1]) / 1024 for line in lines if line.startswith(f"{kind}:")), 0.0)


if __name__ == "__main__":
    print(json.dumps(FleetMeasurement(sys.argv[1], int(sys.argv[2]), float(sys.argv[3])).run()))
