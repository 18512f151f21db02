"""Exploring every order of events of carriers on a ring, agents lagging as they like, beside SPIN on a model by hand.

States a second of one core, by processor time; ours plain and through Numba (compiled before), with every step kept for
what happens in the end, and without. SPIN's model
(`peers/ring.pml`) is a comparable ring, not the same one: it has fewer devices, and no interpreter runs in it. Partial
order reduction is off (`-DNOREDUCE`). The peer is left out where there is no `spin` or no `gcc`.
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

from benchmarks.measuring import Rate, Row, in_turns
from kitrobot.sim import Simulation
from kitrobot.sim.jit_cache import available
from kitrobot.verifier import Budget, Model, Timing, take_apart
from kitrobot.verifier.compiling import engine
from kitrobot.verifier.engines import PLAIN
from kitrobot.verifier.exploring import explore
from kitrobot.workspace import RunOptions, open_mission

TITLE = "checking"
PEER = "SPIN"
_ROOT = Path(__file__).parents[2]


@dataclass(frozen=True)
class Size:
    """How much is explored plain, and through Numba."""

    states: int
    compiled: int
    carriers: tuple[int, ...]
    rounds: int


FULL = Size(states=60_000, compiled=1_000_000, carriers=(2, 3), rounds=3)
TINY = Size(states=200, compiled=200, carriers=(2,), rounds=1)


def run(size: Size, *, peers: bool) -> list[Row]:
    has_peer = peers and shutil.which("spin") is not None and shutil.which("gcc") is not None
    engines = {"plain": PLAIN, **({"Numba": engine.make()} if available() else {})}
    rows = []
    for carriers in size.carriers:
        transport = _transport(carriers)
        found: dict[str, int] = {}

        def exploring(name: str, keeps: bool, run: Simulation = transport, found: dict[str, int] = found) -> None:
            most = size.states if name == "plain" else size.compiled
            made = explore(Model(run, take_apart(run), 0, Timing.FREE), Budget(most), keeps, engines[name])
            found[name] = len(made)

        work = {
            f"{what}, {name}": partial(exploring, name, keeps)
            for name in engines
            for what, keeps in (("safety", False), ("liveness", True))
        }
        seconds = in_turns(work, size.rounds)
        theirs = _spin(carriers, size.rounds) if has_peer else []
        for what, taken in seconds.items():
            beside = bool(theirs) and what.startswith("safety")
            rows.append(
                Row(
                    f"{carriers} carriers, {what}",
                    "states/s",
                    Rate.of(found[what.split(", ")[1]], taken),
                    PEER if beside else "",
                    Rate.of(1, [1 / rate for rate in theirs]) if beside else None,
                )
            )
    return rows


def _transport(carriers: int) -> Simulation:
    """The transport mission with so many carriers, before its first step."""
    opened = open_mission(_ROOT / "examples" / "transport" / "transport.krt")
    team = opened.mission.team
    kept = [one for one in team.agents if one.program != "carrier" or int(one.name[-1]) <= carriers]
    opened = replace(opened, mission=replace(opened.mission, team=replace(team, agents=kept)))
    return opened.prepare(RunOptions(1, 600.0)).simulation


def _spin(carriers: int, rounds: int) -> list[float]:
    """States a second of processor time of SPIN's verifier, each round of a minute at most."""
    rates = []
    with tempfile.TemporaryDirectory() as folder:
        shutil.copy(_ROOT / "benchmarks" / "peers" / "ring.pml", folder)
        make = ["spin", "-a", f"-DCARRIERS={carriers}", "-DBOXES=3", "ring.pml"]
        subprocess.run(make, cwd=folder, check=True, capture_output=True, timeout=60)
        build = ["gcc", "-O2", "-DSAFETY", "-DNOREDUCE", "-DMEMLIM=2000", "-o", "pan", "pan.c"]
        subprocess.run(build, cwd=folder, check=True, capture_output=True, timeout=300)
        for _ in range(rounds):
            before = _children_s()
            said = subprocess.run(
                ["./pan", "-E", "-n", "-m1000000", "-Q1"],
                cwd=folder,
                check=False,
                capture_output=True,
                text=True,
                timeout=300,
            ).stdout
            stored = re.search(r"([0-9.e+]+) states, stored", said)
            if stored is not None:
                rates.append(float(stored[1]) / (_children_s() - before))
    return rates


def _children_s() -> float:
    """Processor time of the processes that were started and have ended."""
    return os.times().children_user + os.times().children_system
