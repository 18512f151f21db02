"""`python -m tools.fleet_networks`: eight agents, each in a network namespace of its own, and what networks do to them.

Needs Linux and root, `ip` and /dev/net/tun. Every agent, the process of the team and a router have a namespace of which
the network card is a TAP of this process; it hands frames on as a switch does, loses and delays them, and can fall in
two. Each scenario runs a mission to its end while something befalls it, and prints what came of it: all units of work
done, each counted once, or the sentence that says why not. In one of them an agent has a board, MicroPython for
WebAssembly at the end of a line in its namespace. Everything that was made is taken away at the end.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import os
import re
import secrets
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple
from xml.etree import ElementTree

from tests.boards.bench import STORES
from tests.boards.modern import ModernBoard
from tools.network_lab import BROKER, TEAM, Lab

AGENTS = 8
UNITS = 24
PORT = 7447
ROUTER = """
import sys, time, zenoh
config = zenoh.Config()
config.insert_json5("mode", '"router"')
config.insert_json5("scouting/multicast/enabled", "false")
config.insert_json5("listen/endpoints", '["' + sys.argv[1] + '"]')
session = zenoh.open(config)
print("ready", flush=True)
while True:
    time.sleep(60)
"""


def mission() -> str:
    """Six workers and two spare ones share out units of work, in step at its beginning and its end."""
    agents = "\n".join(f'<agent name="robot-{n}" program="work" robot="mini-robot"/>' for n in range(1, AGENTS + 1))
    vertices = [
        ("both", "SeqOfPar", "members", "workers"),
        ("on", "Light.LightOn", "", ""),
        ("off", "Light.LightOff", "", ""),
        ("all", "ParOfSeq", "members", "workers"),
        ("again", "Repetition", "count", "9"),
        ("take", "Boxes.Take", "", ""),
        ("shine", "Light.LightOn", "", ""),
        ("wait", "Wait", "duration", "20"),
        ("dark", "Light.LightOff", "", ""),
        ("done", "Boxes.Done", "", ""),
        ("end", "SeqOfPar", "members", "workers"),
        ("last", "Light.LightOn", "", ""),
    ]
    made = "".join(
        f'<vertex id="{name}" element="{element}">{f"""<set name="{key}">{value}</set>""" if key else ""}</vertex>'
        for name, element, key, value in vertices
    )
    arcs = """<arc from="start" to="both"/><arc from="both" out="body" to="on"/><arc from="on" to="off"/>
      <arc from="off" to="both" at="return"/><arc from="both" to="all"/><arc from="all" out="body" to="again"/>
      <arc from="again" out="body" to="take"/><arc from="take" to="shine"/><arc from="shine" to="wait"/>
      <arc from="wait" to="dark"/><arc from="dark" to="done"/><arc from="done" to="again" at="return"/>
      <arc from="again" to="all" at="return"/><arc from="all" to="end"/><arc from="end" out="body" to="last"/>
      <arc from="last" to="end" at="return"/><arc from="end" to="stop"/>"""
    return f"""<kitrobot version="1"><program name="work" level="social"><vertex id="start" element="Start"/>{made}
      <vertex id="stop" element="Stop"/>{arcs}</program><team>{agents}
      <role name="worker" robot="mini-robot" least="6"/><group name="workers" members="worker" failure="substitute"/>
      <work name="Boxes" units="{UNITS}" lease="30"/></team><world href="eight.world.xml"/></kitrobot>"""


def world() -> str:
    starts = "".join(f'<start name="robot-{n}" x="300" y="{200 * n}" heading="0"/>' for n in range(1, AGENTS + 1))
    return f'<world version="1" name="eight" width="2600" height="2000">{starts}</world>'


def written(folder: Path) -> Path:
    """The mission of eight agents, in a file."""
    (folder / "eight.world.xml").write_text(world())
    file = folder / "eight.krt"
    file.write_text(mission())
    return file


def copied(mission: Path, folder: Path) -> Path:
    """A mission with all that lies beside it."""
    shutil.copytree(mission.parent, folder, dirs_exist_ok=True)
    return folder / mission.name


def agents_of(file: Path) -> list[str]:
    """The names of a mission's agents."""
    return [agent.attrib["name"] for agent in ElementTree.parse(file).iter("agent")]


class Fleet:
    """A run: its processes, and what they said. `board`: the body of the first agent where that is not simulated."""

    def __init__(self, lab: Lab, file: Path, setting: Setting, board: ModernBoard | None = None) -> None:
        self.lab = lab
        self.board = board
        self.lines: list[str] = []
        self.key = file.with_name("key")
        self.key.write_text(secrets.token_hex(32))
        self.file = str(file)
        self.names = agents_of(file)
        router, lease = setting.router, setting.lease
        if board is not None:
            file.with_name("lamp.driver.py").write_text(STORES.format(mark=0))
            words = ("-m", "kitrobot", "deploy", self.file, "--team", "--board", f"robot-1={board.address}")
            sending = lab.start("0", *words)
            out, err = sending.communicate(timeout=120)
            assert sending.returncode == 0, out + err
        self.router = router
        self.broker = self.start_router() if router else None
        names = [word for name in self.names for word in ("--elsewhere", name)]
        at = self.endpoint(TEAM)
        way = ("--router", self.endpoint(BROKER)) if router else ("--listen", at)
        self.team = lab.start(
            TEAM, "-m", "kitrobot", "team", self.file, *names, *way, *self.common(), "--lease", str(lease), "--json",
            "--seconds", "300",
        )  # fmt: skip
        self.agents = [self.start_agent(n) for n in range(len(self.names))]
        self.reader = threading.Thread(target=self.read, daemon=True)
        self.reader.start()

    def common(self) -> tuple[str, ...]:
        return ("--key", str(self.key), "--fleet", "lab")

    def endpoint(self, place: str, port: int = PORT) -> str:
        return f"tcp/{self.lab.address(place)}:{port}"

    def start_router(self) -> subprocess.Popen[str]:
        router = self.lab.start(BROKER, "-c", ROUTER, self.endpoint(BROKER), quiet=True)
        assert router.stdout is not None
        router.stdout.readline()
        return router

    def start_agent(self, n: int, place: str = "") -> subprocess.Popen[str]:
        """The process of an agent, in its own namespace or in another one."""
        place = place or str(n)
        way = ("--router", self.endpoint(BROKER)) if self.router else ("--connect", self.endpoint(TEAM))
        own = () if self.router else ("--listen", self.endpoint(place, 7400))
        words = ("-m", "kitrobot", "agent", self.file, "--as", self.names[n], *way, *own, *self.common(), "--json")
        if n == 0 and self.board is not None:
            words += ("--board", self.board.address)
        return self.lab.start(place, *words, quiet=True)

    def read(self) -> None:
        assert self.team.stderr is not None
        for line in self.team.stderr:
            self.lines.append(line.rstrip())

    def until(self, text: str, seconds: float = 60.0) -> bool:
        """Waits until the team said something."""
        end = time.monotonic() + seconds
        while time.monotonic() < end and self.team.poll() is None:
            if any(re.search(text, line) for line in self.lines):
                return True
            time.sleep(0.02)
        return False

    def signal(self, n: int, what: signal.Signals) -> None:
        os.kill(self.agents[n].pid, what)


Scenario = Callable[[Fleet, Lab], None]


def nothing(fleet: Fleet, lab: Lab) -> None:
    """nothing"""


def kill(fleet: Fleet, lab: Lab) -> None:
    """kill -9 of two agents, 3 s apart"""
    fleet.signal(0, signal.SIGKILL)
    time.sleep(3)
    fleet.signal(1, signal.SIGKILL)


def restart(fleet: Fleet, lab: Lab) -> None:
    """kill -9 of three agents, each is started again"""
    for n in range(3):
        fleet.signal(n, signal.SIGKILL)
        time.sleep(2)
        fleet.agents[n] = fleet.start_agent(n)


def pause(fleet: Fleet, lab: Lab) -> None:
    """SIGSTOP of the first agent for 5 s"""
    fleet.signal(0, signal.SIGSTOP)
    time.sleep(5)
    fleet.signal(0, signal.SIGCONT)


def lossy(fleet: Fleet, lab: Lab) -> None:
    """10 % of all frames are lost"""
    lab.switch.loss = 0.1


def slow(fleet: Fleet, lab: Lab) -> None:
    """every frame 200 ms late"""
    lab.switch.delay = 0.2


def partition(fleet: Fleet, lab: Lab) -> None:
    """three agents cut off for 5 s"""
    lab.switch.side = {0, 1, 2}
    time.sleep(5)
    lab.switch.side = set()


def gone(fleet: Fleet, lab: Lab) -> None:
    """two agents cut off for good"""
    lab.switch.side = {0, 1}


def late_heal(fleet: Fleet, lab: Lab) -> None:
    """two agents cut off for 15 s, longer than Zenoh bears a silent link"""
    lab.switch.side = {0, 1}
    time.sleep(15)
    lab.switch.side = set()


def doubled(fleet: Fleet, lab: Lab) -> None:
    """a second process under the name of an agent that takes part"""
    second = fleet.start_agent(2, TEAM)
    out, _ = second.communicate(timeout=60)
    fleet.lines.append(out)
    assert second.returncode == 1
    assert "one name is one process" in out


def halves(fleet: Fleet, lab: Lab) -> None:
    """a partition while a view changes: kill -9, 0.8 s later three others are cut off for 4 s"""
    fleet.signal(7, signal.SIGKILL)
    time.sleep(0.8)
    lab.switch.side = {4, 5, 6}
    time.sleep(4)
    lab.switch.side = set()


def dead_router(fleet: Fleet, lab: Lab) -> None:
    """the router dies, and is there again 3 s later"""
    assert fleet.broker is not None
    fleet.broker.kill()
    fleet.broker.wait()
    time.sleep(3)
    fleet.broker = fleet.start_router()


def cable(fleet: Fleet, lab: Lab) -> None:
    """the first agent is a board, whose cable is pulled after 6 s"""
    assert fleet.board is not None
    time.sleep(6)
    fleet.board.process.kill()


class Setting(NamedTuple):
    """What happens in a run, the lease of work in ms, and what there is besides the agents."""

    scenario: Scenario
    lease: int = 500
    router: bool = False
    board: bool = False


SCENARIOS = {
    "nothing": Setting(nothing),
    "kill": Setting(kill),
    "restart": Setting(restart),
    "pause": Setting(pause),
    "loss": Setting(lossy, 2000),
    "delay": Setting(slow, 1500),
    "partition": Setting(partition),
    "gone": Setting(gone),
    "heal": Setting(late_heal),
    "double": Setting(doubled),
    "view": Setting(halves),
    "router": Setting(dead_router, router=True),
    "board": Setting(cable, 2000, board=True),
}


def try_out(name: str, setting: Setting, show: bool, given: Path | None) -> bool:
    """Runs a scenario in a lab of its own, with the mission of eight agents or the one that is given."""
    with contextlib.ExitStack() as stack:
        folder = Path(stack.enter_context(tempfile.TemporaryDirectory()))
        file = copied(given, folder) if given else written(folder)
        lab = stack.enter_context(Lab(len(agents_of(file))))
        board = stack.enter_context(ModernBoard(within=lab.within("0"))) if setting.board else None
        fleet = Fleet(lab, file, setting, board)
        if not fleet.until("all agents are there", 90):
            print(f"{name}: did not begin\n" + "\n".join(fleet.lines))
            return False
        time.sleep(2)
        began = time.monotonic()
        setting.scenario(fleet, lab)
        try:
            fleet.team.wait(600)
        except subprocess.TimeoutExpired:
            print(f"{name}: came to no end\n" + "\n".join(fleet.lines[-30:]))
            return False
        took = time.monotonic() - began
        fleet.reader.join(5)
        assert fleet.team.stdout is not None
        out = fleet.team.stdout.read()
        result = json.loads(out) if out.strip() else {}
        left = [one for one in fleet.agents if one.poll() is None]
        for one in left:
            try:
                one.wait(30)
            except subprocess.TimeoutExpired:
                print(f"{name}: an agent is still there")
                return False
        units = result.get("units", {}).get("Boxes")
        good = result.get("outcome") == "done" and (units == UNITS or given is not None)
        counted = "" if given else f" {units}/{UNITS} units,"
        print(f"{'ok  ' if good else 'BAD '} {name:10}{counted} {took:5.1f} s: {setting.scenario.__doc__}")
        print(f"     {result.get('sentence', '')}")
        if show or not good:
            print("\n".join(f"       {line}" for line in fleet.lines))
        return good


def main() -> int:
    """Status 1 when something did not come to its end."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("scenario", nargs="*", help=f"some of {', '.join(SCENARIOS)}")
    parser.add_argument("--log", action="store_true", help="show what the team said")
    parser.add_argument(
        "--mission",
        type=Path,
        help="a mission of at least eight agents, whose goal decides, instead of the built-in one",
    )
    parser.add_argument(
        "--lease", type=int, help="ms; instead of the scenario's own, on a machine with little to spare"
    )
    given = parser.parse_args()
    if not sys.platform.startswith("linux") or os.geteuid() != 0:
        print("this needs Linux, and root for network namespaces", file=sys.stderr)
        return 2
    # The board is built for the built-in mission.
    names = given.scenario or [name for name, setting in SCENARIOS.items() if not (given.mission and setting.board)]
    leases = {"lease": given.lease} if given.lease else {}
    results = [try_out(name, SCENARIOS[name]._replace(**leases), given.log, given.mission) for name in names]
    return 0 if all(results) else 1


if __name__ == "__main__":
    raise SystemExit(main())
