"""Exploring every order of events of carriers on a ring, agents lagging as they like, beside SPIN on a model by hand.

States a second of one core; ours with every step kept for what happens in the end, and without. SPIN's model
(`peers/ring.pml`) is a comparable ring, not the same one: it has fewer devices, and no interpreter runs in it. Partial
order reduction is off (`-DNOREDUCE`). The peer is left out where there is no `spin` or no `gcc`.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import tempfile
from dataclasses import dataclass, replace
from pathlib import Path

from benchmarks.measuring import Rate, Row, in_turns
from kitrobot.sim import Simulation
from kitrobot.verifier import Budget, Model, Timing, take_apart
from kitrobot.verifier.exploring import explore
from kitrobot.verifier.timing import Clock
from kitrobot.workspace import RunOptions, open_mission

TITLE = "checking"
PEER = "SPIN"
_ROOT = Path(__file__).parents[2]


@dataclass(frozen=True)
class Size:
    states: int
    carriers: tuple[int, ...]
    rounds: int


FULL = Size(states=60_000, carriers=(2, 3), rounds=3)
TINY = Size(states=200, carriers=(2,), rounds=1)


def run(size: Size, *, peers: bool) -> list[Row]:
    has_peer = peers and shutil.which("spin") is not None and shutil.which("gcc") is not None
    rows = []
    for carriers in size.carriers:
        transport = _transport(carriers)
        found: dict[str, int] = {}

        def exploring(keeps: bool, run: Simulation = transport, found: dict[str, int] = found) -> None:
            clock = Clock(Model(run, take_apart(run)), Timing.FREE)
            made = explore(clock, Budget(size.states), lambda number, state, step, after: True, keeps)
            found["safety"] = len(made.states)

        seconds = in_turns({"safety": lambda: exploring(False), "liveness": lambda: exploring(True)}, size.rounds)
        theirs = _spin(carriers, 1) if has_peer else []
        for what, taken in seconds.items():
            rows.append(
                Row(
                    f"{carriers} carriers, {what}",
                    "states/s",
                    Rate.of(found["safety"], taken),
                    PEER if theirs and what == "safety" else "",
                    Rate.of(1, [1 / rate for rate in theirs]) if theirs and what == "safety" else None,
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
    """States a second of SPIN's verifier, each round of a minute at most."""
    rates = []
    with tempfile.TemporaryDirectory() as folder:
        shutil.copy(_ROOT / "benchmarks" / "peers" / "ring.pml", folder)
        make = ["spin", "-a", f"-DCARRIERS={carriers}", "-DBOXES=3", "ring.pml"]
        subprocess.run(make, cwd=folder, check=True, capture_output=True, timeout=60)
        build = ["gcc", "-O2", "-DSAFETY", "-DNOREDUCE", "-DMEMLIM=2000", "-o", "pan", "pan.c"]
        subprocess.run(build, cwd=folder, check=True, capture_output=True, timeout=300)
        for _ in range(rounds):
            said = subprocess.run(
                ["./pan", "-E", "-n", "-m1000000", "-Q1"],
                cwd=folder,
                check=False,
                capture_output=True,
                text=True,
                timeout=300,
            ).stdout
            rate = re.search(r"pan: rate +([0-9.e+]+) states/second", said)
            if rate is not None:
                rates.append(float(rate[1]))
    return rates
