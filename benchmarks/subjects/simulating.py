"""The simulator's step, plain and under Numba: robots in their thousands, how the cost grows, the transport mission.

A step of the swarm is 20 ms of all its robots (see benchmarks/swarm.py): three range rays each, 21 instructions,
driving, collisions with walls and one another. Beside it Mesa's agents with a neighbour query, and py_trees' trees
ticking, which do a part of that. Counted: steps. Not counted: setup, Numba's compilation, a round to warm up;
watching and recording. The transport mission runs from its start to its end without a trace, setup included; the
unit is simulated seconds a second.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import kitrobot
from benchmarks.measurement import Rate, Row, in_turns
from benchmarks.swarm import SPACING_MM, instructions_a_tick, swarm
from benchmarks.table import table
from kitrobot.mission.radio import Radio
from kitrobot.sim.jit import cache as jit_cache
from kitrobot.sim.simulation import Simulation

TITLE = "simulating"
TRANSPORT = Path(__file__).resolve().parents[2] / "examples" / "transport" / "transport.krt"


@dataclass(frozen=True)
class Size:
    """`beside`: numbers of robots with peers; `growth`: others, under Numba alone. `work`: robots × steps a round."""

    beside: tuple[int, ...]
    growth: tuple[int, ...]
    talking: int
    """Robots that share a variable, without a radio and with one."""
    pushing: tuple[int, int]
    """Boxes on a table, and robots that push them."""
    work: int
    plain_work: int
    rounds: int


FULL = Size((100, 1000, 10_000), (10, 100_000), 1000, (500, 50), 1_000_000, 10_000, 5)
TINY = Size((4,), (9,), 5, (6, 2), 20, 20, 1)


def go(run: Simulation, steps: int) -> None:
    """So many steps; the run must not end before."""
    done = 0
    while done < steps:
        done += run.advance(steps - done)
        assert run.outcome is None, run.sentence


def hurried(run: Simulation) -> Simulation:
    """The run, under Numba from now on."""
    assert run.compile_step(), "Numba does not compile the step"
    run.advance(1)
    return run


def run(size: Size, *, peers: bool) -> list[Row]:
    rows: list[Row] = []
    for robots in size.beside:
        rows += _beside(robots, size, peers)
    if jit_cache.available():
        for robots in size.growth:
            rows.append(Row(f"Numba, {robots} robots", "steps/s", _numba(robots, size)))
    return rows + _talking(size, peers) + _pushing(size, peers) + _transport(size)


def _numba(robots: int, size: Size) -> Rate:
    steps = max(1, size.work // robots)
    ours = hurried(swarm(robots))
    return Rate.of(steps, in_turns({"": lambda: go(ours, steps)}, size.rounds)[""])


def _beside(robots: int, size: Size, peers: bool) -> list[Row]:
    plain_steps = max(1, size.plain_work // robots)
    steps = {"plain": plain_steps}
    plain = swarm(robots)
    plain.stays_plain = True
    work: dict[str, Callable[[], object]] = {"plain": lambda: go(plain, plain_steps)}
    if jit_cache.available():
        ours = hurried(swarm(robots))
        steps["Numba"] = max(1, size.work // robots)
        work["Numba"] = lambda: go(ours, steps["Numba"])
    names: dict[str, str] = {}
    if peers:
        from benchmarks.peers import agents_in_space, trees

        names = {"mesa": agents_in_space.NAME, "trees": trees.NAME}
        mesa = agents_in_space.Rovers(robots, SPACING_MM)
        forest = trees.forest(robots)
        steps["mesa"] = steps["trees"] = plain_steps
        work["mesa"] = lambda: mesa.go(plain_steps)
        work["trees"] = lambda: trees.tick(forest, plain_steps)
    seconds = in_turns(work, size.rounds)
    rates = {name: Rate.of(steps[name], taken) for name, taken in seconds.items()}
    rows = []
    for name in ("plain", "Numba"):
        if name not in rates:
            continue
        what = f"{name}, {robots} robots of {instructions_a_tick()} instructions"
        rows += [Row(what, "steps/s", rates[name], told, rates[peer]) for peer, told in names.items()]
        if not peers:
            rows.append(Row(what, "steps/s", rates[name]))
    return rows


def _pushing(size: Size, peers: bool) -> list[Row]:
    """A table of boxes that robots push, beside a physics engine in C."""
    boxes, robots = size.pushing
    steps = {"plain": max(1, size.plain_work // (boxes + robots)), "Numba": max(1, size.work // (boxes + robots))}
    plain = table(boxes, robots)
    plain.stays_plain = True
    work: dict[str, Callable[[], object]] = {"plain": lambda: go(plain, steps["plain"])}
    if jit_cache.available():
        ours = hurried(table(boxes, robots))
        work["Numba"] = lambda: go(ours, steps["Numba"])
    name = ""
    if peers:
        from benchmarks.peers import pushed_things

        name = pushed_things.NAME
        theirs = pushed_things.Table(boxes, robots)
        steps["pymunk"] = steps["Numba"]
        work["pymunk"] = lambda: theirs.go(steps["pymunk"])
    rates = {what: Rate.of(steps[what], taken) for what, taken in in_turns(work, size.rounds).items()}
    beside = (name, rates["pymunk"]) if peers else ()
    what = f"a table of {boxes} boxes and {robots} robots"
    return [Row(f"{one}, {what}", "steps/s", rates[one], *beside) for one in ("plain", "Numba") if one in rates]


RADIO = Radio(range_mm=1000, delay_ms=20, loss=5)


def _talking(size: Size, peers: bool) -> list[Row]:
    """Robots that share a variable over a radio of range, delay and loss, beside the same who all hear at once."""
    rows = []
    for name in ("plain", "Numba") if jit_cache.available() else ("plain",):
        steps = max(1, (size.work if name == "Numba" else size.plain_work) // size.talking)
        runs = {"at once": swarm(size.talking, talks=True), "radio": swarm(size.talking, talks=True, radio=RADIO)}
        for one in runs.values():
            if name == "Numba":
                hurried(one)
            else:
                one.stays_plain = True
        seconds = in_turns({what: partial(go, one, steps) for what, one in runs.items()}, size.rounds)
        rates = {what: Rate.of(steps, taken) for what, taken in seconds.items()}
        what = f"{name}, {size.talking} robots that share a variable over a radio"
        beside = ("without a radio", rates["at once"]) if peers else ()
        rows.append(Row(what, "steps/s", rates["radio"], *beside))
    return rows


def _transport(size: Size) -> list[Row]:
    opened = kitrobot.open(TRANSPORT)
    simulated: dict[str, float] = {}

    def mission(name: str) -> None:
        run = opened.simulation(seed=1)
        if name == "Numba":
            assert run.compile_step()
        else:
            run.stays_plain = True
        while run.outcome is None:
            run.advance(10_000)
        assert run.outcome == "done"
        simulated[name] = run.seconds

    work: dict[str, Callable[[], object]] = {"plain": lambda: mission("plain")}
    if jit_cache.available():
        work["Numba"] = lambda: mission("Numba")
    seconds = in_turns(work, size.rounds)
    return [
        Row(f"transport, {name}, setup included", "× real time", Rate.of(simulated[name], taken))
        for name, taken in seconds.items()
    ]
