"""Exploring every order of events of carriers on a ring, agents lagging as they like, beside SPIN on a model by hand.

States a second of one core, by processor time, and bytes a state; ours plain and through Numba (compiled before), with
every step kept for what happens in the end, and without. SPIN's model (`peers/ring.pml`) is a comparable ring, not the
same one: it has fewer devices, and no interpreter runs in it. Partial order reduction is off (`-DNOREDUCE`). Its
*liveness* looks for fair rounds while it explores (`-a -f`), ours once the steps are kept, which is not in these rows.
Its bytes are those of the states alone; ours are states, the table to find them by, steps and the model's tables. The
peer is left out where there is no `spin` or no `gcc`.

With `strong` numbers of carriers: the exact search on all cores beside one, the approximate one on one core and on all,
and SPIN's modes that save memory (COLLAPSE, HC4, BITSTATE). Of several cores the seconds are processor time of the
thread that is longest at it, those of the main thread included: what it takes where each core is free. Bytes of
the approximate search are its filter, how each state was reached, keys that wait, its batch and the model's tables;
SPIN's of BITSTATE the bits, and its stack.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import tempfile
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any

from benchmarks.measurement import Rate, Row, in_turns
from kitrobot.mission.model import Agent
from kitrobot.sim.jit.cache import available
from kitrobot.sim.simulation import Simulation
from kitrobot.verifier.exploration.approximate_search import explore_approximately
from kitrobot.verifier.exploration.budget import Budget
from kitrobot.verifier.exploration.engines import PLAIN, Engine
from kitrobot.verifier.exploration.exploration import explore
from kitrobot.verifier.exploration.numba_engine import engine
from kitrobot.verifier.model.abstraction import abstract_run
from kitrobot.verifier.model.model import Model
from kitrobot.verifier.model.timing import Timing
from kitrobot.workspace.child_processes import cores
from kitrobot.workspace.mission_loader import open_mission
from kitrobot.workspace.mission_run import RunOptions
from kitrobot.world.model import Start

TITLE = "checking"
PEER = "SPIN"
_ROOT = Path(__file__).parents[2]


@dataclass(frozen=True)
class Size:
    """How much is explored plain, and through Numba (0: nothing); the peer has a round for each number of carriers.

    `strong`: the numbers of carriers for the modes that are for many states, of which `most` are explored.
    """

    states: int
    compiled: int
    carriers: tuple[int, ...]
    rounds: int
    strong: tuple[int, ...] = ()
    most: int = 0


FULL = Size(states=60_000, compiled=1_000_000, carriers=(2, 3, 4, 5), rounds=3, strong=(3,), most=8_000_000)
TINY = Size(states=200, compiled=200, carriers=(2, 5), rounds=1, strong=(2,), most=400)
STRONG = {"COLLAPSE": "-DCOLLAPSE", "HC4": "-DHC4", "BITSTATE": "-DBITSTATE"}


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
    if size.compiled and available():
        for carriers in size.strong:
            rows += _strong_rows(carriers, size.most, engine.make(), has_peer)
    return rows


def _strong_rows(carriers: int, most: int, compiled: Engine, has_peer: bool) -> list[Row]:
    """Many states: exactly and approximately, on one core and on all, beside SPIN's modes; one round of each."""
    transport, rows = _transport(carriers), []
    rates: dict[str, tuple[Rate, Rate]] = {}
    for what in ("exact", "approximate"):
        for name, workers in (("one core", 1), ("all cores", cores())):
            times = _ThreadTimes()
            model = Model(transport, abstract_run(transport), 0, Timing.FREE)
            budget, timed = Budget(most, cores=workers, alone=0), times.around(compiled)
            begun = time.thread_time()
            if what == "exact":
                made = explore(model, budget, False, timed)
            else:
                made = explore_approximately(model, budget, lambda space, first, end: None, engine=timed)
            seconds = time.thread_time() - begun + times.longest_s
            rates[f"{what}, {name}"] = _one(len(made) / seconds), _one(made.memory / len(made))
    theirs = {mode: _spin(carriers, "safety", option) for mode, option in STRONG.items()} if has_peer else {}
    beside = {"exact": ["COLLAPSE", "HC4"], "approximate": ["BITSTATE"]}
    for head, (rate, each) in rates.items():
        for mode in beside[head.split(", ")[0]]:
            peer = theirs.get(mode)
            name, other = f"{PEER} {mode}", (None, None) if peer is None else (_one(peer.rate), _one(peer.bytes))
            rows.append(Row(f"{carriers} carriers, {head}", "states/s", rate, name, other[0]))
            rows.append(Row(f"{carriers} carriers, {head}", "bytes/state", each, name, other[1], True))
    return rows


class _ThreadTimes:
    """How long other threads than the one that made it are in the functions of an engine, in processor time."""

    def __init__(self) -> None:
        self._own = threading.get_ident()
        self._seconds: dict[int, float] = {}

    @property
    def longest_s(self) -> float:
        """Seconds of the thread that was longest in them."""
        return max(self._seconds.values(), default=0.0)

    def around(self, compiled: Engine) -> Engine:
        """The engine with its functions timed that threads call."""
        return compiled._replace(
            explore_states=self._timed(compiled.explore_states),
            insert_steps=self._timed(compiled.insert_steps),
            filter_steps=self._timed(compiled.filter_steps),
        )

    def _timed(self, function: Callable[..., int]) -> Callable[..., int]:
        def call(*arguments: Any) -> int:
            thread, begun = threading.get_ident(), time.thread_time()
            made = function(*arguments)
            if thread != self._own:
                self._seconds[thread] = self._seconds.get(thread, 0.0) + time.thread_time() - begun
            return made

        return call


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


def _spin(carriers: int, what: str, mode: str = "") -> Peer | None:
    """What SPIN's verifier makes of its model, a minute at most; None where it says nothing."""
    claim, searches = ([], ["-E"]) if what == "safety" else (["-DLIVE"], ["-a", "-f", "-c0"])
    with tempfile.TemporaryDirectory() as folder:
        shutil.copy(_ROOT / "benchmarks" / "peers" / "ring.pml", folder)
        make = ["spin", "-a", *claim, f"-DCARRIERS={carriers}", "-DBOXES=3", "ring.pml"]
        subprocess.run(make, cwd=folder, check=True, capture_output=True, timeout=60)
        options = ["-DSAFETY"] if what == "safety" else ["-DNFAIR=6"]
        options += [mode] if mode else []
        build = ["gcc", "-O2", *options, "-DNOREDUCE", "-DMEMLIM=2000", "-o", "pan", "pan.c"]
        subprocess.run(build, cwd=folder, check=True, capture_output=True, timeout=300)
        before = _children_s()
        run = ["./pan", *searches, "-n", "-m1000000", "-Q1"]
        said = subprocess.run(run, cwd=folder, check=False, capture_output=True, text=True, timeout=300).stdout
        taken = _children_s() - before
    stored = re.search(r"([0-9.e+]+) states, stored", said)
    # Of bits it does not tell what states take, so all of its memory counts.
    kind = "total actual memory usage" if mode == STRONG["BITSTATE"] else "actual memory usage for states"
    memory = re.search(rf"([0-9.]+)\s+{kind}", said)
    if stored is None or memory is None:
        return None
    return Peer(float(stored[1]) / taken, float(memory[1]) * 2**20 / float(stored[1]))


def _children_s() -> float:
    """Processor time of the processes that were started and have ended."""
    return os.times().children_user + os.times().children_system
