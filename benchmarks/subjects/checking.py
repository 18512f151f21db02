"""Exploring every order of events of carriers on a ring, agents lagging as they like, beside SPIN on a model by hand.

States a second of one core, by processor time, and bytes a state; ours plain and through Numba (compiled before), with
every step kept for what happens in the end, and without. SPIN's model (`peers/ring.pml`) is a comparable ring, not the
same one: it has fewer devices, and no interpreter runs in it. Partial order reduction is off (`-DNOREDUCE`). Its
*liveness* looks for fair rounds while it explores (`-a -f`), ours once the steps are kept, which is not in these rows.
Its bytes are those of the states alone; ours are states, the table to find them by, steps and the model's tables. The
peer is left out where there is no `spin` or no `gcc`.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import tempfile
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

from benchmarks.measurement import Rate, Row, in_turns
from kitrobot.mission.model import Agent
from kitrobot.sim.jit.cache import available
from kitrobot.sim.simulation import Simulation
from kitrobot.verifier.exploration.budget import Budget
from kitrobot.verifier.exploration.engines import PLAIN
from kitrobot.verifier.exploration.exploration import explore
from kitrobot.verifier.exploration.numba_engine import engine
from kitrobot.verifier.model.abstraction import abstract_run
from kitrobot.verifier.model.model import Model
from kitrobot.verifier.model.timing import Timing
from kitrobot.workspace.mission_loader import open_mission
from kitrobot.workspace.mission_run import RunOptions
from kitrobot.world.model import Start

TITLE = "checking"
PEER = "SPIN"
_ROOT = Path(__file__).parents[2]


@dataclass(frozen=True)
class Size:
    """How much is explored plain, and through Numba (0: nothing); the peer has a round for each number of carriers."""

    states: int
    compiled: int
    carriers: tuple[int, ...]
    rounds: int


FULL = Size(states=60_000, compiled=1_000_000, carriers=(2, 3, 4, 5), rounds=3)
TINY = Size(states=200, compiled=200, carriers=(2, 5), rounds=1)


@dataclass(frozen=True)
class Peer:
    """What SPIN says of one model: states a second of processor time, and bytes that each takes."""

    rate: float
    bytes: float


def run(size: Size, *, peers: bool) -> list[Row]:
    has_peer = peers and shutil.which("spin") is not None and shutil.which("gcc") is not None
    engines = {"plain": PLAIN, **({"Numba": engine.make()} if size.compiled and available() else {})}
    rows = []
    for carriers in size.carriers:
        transport = _transport(carriers)
        found: dict[str, tuple[int, int]] = {}

        def exploring(
            what: str,
            name: str,
            run: Simulation = transport,
            found: dict[str, tuple[int, int]] = found,
        ) -> None:
            most = size.states if name == "plain" else size.compiled
            model = Model(run, abstract_run(run), 0, Timing.FREE)
            made = explore(model, Budget(most), what == "liveness", engines[name])
            found[f"{what}, {name}"] = len(made), made.memory

        kinds = ("safety", "liveness")
        work = {f"{what}, {name}": partial(exploring, what, name) for name in engines for what in kinds}
        seconds = in_turns(work, size.rounds)
        for what in kinds:
            theirs = _spin(carriers, what) if has_peer else None
            for name in engines:
                states, memory = found[f"{what}, {name}"]
                beside = theirs is not None and name == list(engines)[-1]
                peer = PEER if beside else ""
                head = f"{carriers} carriers, {what}, {name}"
                rate = Rate.of(states, seconds[f"{what}, {name}"])
                rows.append(Row(head, "states/s", rate, peer, _one(theirs.rate) if theirs and beside else None))
                if name == list(engines)[-1]:
                    each = _one(memory / states)
                    rows.append(Row(head, "bytes/state", each, peer, _one(theirs.bytes) if theirs else None, True))
    return rows


def _one(value: float) -> Rate:
    return Rate(value, value, value)


def _transport(carriers: int) -> Simulation:
    """The transport mission with so many carriers, before its first step; from the fourth on they stand behind one
    another.
    """
    opened = open_mission(_ROOT / "examples" / "transport" / "transport.krt")
    team, world = opened.mission.team, opened.world
    assert world is not None
    kept = [one for one in team.agents if one.program != "carrier" or int(one.name[-1]) <= carriers]
    for number in range(4, carriers + 1):
        kept.insert(number - 1, Agent(f"carrier-{number}", "carrier"))
        start = Start(f"carrier-{number}", road="ring", at_mm=1100.0 - 140.0 * (number - 3))
        world = replace(world, starts=(*world.starts, start))
    opened = replace(opened, mission=replace(opened.mission, team=replace(team, agents=kept)), world=world)
    return opened.prepare(RunOptions(1, 600.0)).simulation


def _spin(carriers: int, what: str) -> Peer | None:
    """What SPIN's verifier makes of its model, a minute at most; None where it says nothing."""
    claim, searches = ([], ["-E"]) if what == "safety" else (["-DLIVE"], ["-a", "-f", "-c0"])
    with tempfile.TemporaryDirectory() as folder:
        shutil.copy(_ROOT / "benchmarks" / "peers" / "ring.pml", folder)
        make = ["spin", "-a", *claim, f"-DCARRIERS={carriers}", "-DBOXES=3", "ring.pml"]
        subprocess.run(make, cwd=folder, check=True, capture_output=True, timeout=60)
        options = ["-DSAFETY"] if what == "safety" else ["-DNFAIR=6"]
        build = ["gcc", "-O2", *options, "-DNOREDUCE", "-DMEMLIM=2000", "-o", "pan", "pan.c"]
        subprocess.run(build, cwd=folder, check=True, capture_output=True, timeout=300)
        before = _children_s()
        run = ["./pan", *searches, "-n", "-m1000000", "-Q1"]
        said = subprocess.run(run, cwd=folder, check=False, capture_output=True, text=True, timeout=300).stdout
        taken = _children_s() - before
    stored = re.search(r"([0-9.e+]+) states, stored", said)
    memory = re.search(r"([0-9.]+)\s+actual memory usage for states", said)
    if stored is None or memory is None:
        return None
    return Peer(float(stored[1]) / taken, float(memory[1]) * 2**20 / float(stored[1]))


def _children_s() -> float:
    """Processor time of the processes that were started and have ended."""
    return os.times().children_user + os.times().children_system
