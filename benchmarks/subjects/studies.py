"""Studies: runs a second on one core, against a plain loop over `run` and against Mesa's batch runner; what is kept.

The transport mission runs from its start to its end with each seed; a plain loop sets it up anew for each. The little
model is ten robots that drive for two simulated seconds, look ahead and turn away; Mesa's do a part of that (see
benchmarks/peers/agents_in_space.py) for as many steps. `kept` writes the rows of that model into a study's folder too,
on the disk before the next look; `measured` adds up something after every step. The unit is runs a second of processor
time, Numba's compilation not counted; where there is no Numba, steps are plain. The summary is that of rows which are
written as a study's are and are no runs: a hundred points, four measures.
"""

from __future__ import annotations

import random
import tempfile
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path

import kitrobot
from benchmarks.measurement import Rate, Row, in_turns, milliseconds
from kitrobot.experiments.executor import Work
from kitrobot.experiments.measures import read_measures
from kitrobot.experiments.plan import Plan, StudyRequest, plan_study
from kitrobot.experiments.point_runner import Pace, PointRunner, row_bytes
from kitrobot.experiments.study import Study
from kitrobot.experiments.study_folder import begin_study
from kitrobot.experiments.study_run import run_study
from kitrobot.workspace.mission_loader import OpenMission

TITLE = "studies"
SPACING_MM = 400.0
SECONDS, STEPS = 2.0, 100
LONGER = 10
"""How many times as long the longer runs of the little model are."""
PROGRAM = "Wheel.Advance(30); *[Captor.LessThan(1000)]([Captor.LessThan(15)](Motor.AbsoluteTurn(25, 50);));"
MEASURED = "distance, near=time any go (Captor.LessThan(30))"
"""What is added up after every step."""


@dataclass(frozen=True)
class Size:
    """`transport`: runs of the transport mission a round; `small`: of the little model, of so many `robots`; `peer`:
    of Mesa's; `rows`: rows of which a summary is made.
    """

    transport: int
    small: int
    peer: int
    robots: int
    rows: int
    rounds: int


FULL = Size(40, 2000, 20, 10, 1_000_000, 5)
TINY = Size(1, 2, 2, 2, 1000, 1)
POINTS = 100


def run(size: Size, *, peers: bool) -> list[Row]:
    return [_transport(size, peers), *_small(size, peers), _summary(size)]


def _transport(size: Size, peers: bool) -> Row:
    opened = kitrobot.open_mission("transport")
    plan = plan_study(opened, StudyRequest(seeds=f"1-{size.transport}"))
    runner = PointRunner(plan, pace=Pace.COMPILED)
    rates = _rates(
        {
            "study": lambda: [runner.run(row) for row in range(plan.rows)],
            "loop": lambda: [opened.run(seed=seed) for seed in range(1, size.transport + 1)],
        },
        size.transport,
        size.rounds,
    )
    return Row("transport", "runs/s", rates["study"], "a loop over run()", rates["loop"] if peers else None)


def _small(size: Size, peers: bool) -> list[Row]:
    opened = little_model(size.robots)
    plan = plan_study(opened, StudyRequest(seeds=f"1-{size.small}", seconds=SECONDS, measures=["collisions"]))
    runner = PointRunner(plan, pace=Pace.COMPILED)
    measured_plan = replace(plan, measures=tuple(read_measures([MEASURED])))
    measured = PointRunner(measured_plan, pace=Pace.COMPILED)
    longer_runs = max(1, size.small // LONGER)
    longer_plan = plan_study(
        opened, StudyRequest(seeds=f"1-{longer_runs}", seconds=LONGER * SECONDS, measures=["ticks"])
    )
    longer = PointRunner(longer_plan, pace=Pace.COMPILED)
    work: dict[str, Callable[[], object]] = {
        "bare": lambda: [runner.run(row) for row in range(plan.rows)],
        "kept": lambda: _kept(plan, runner),
        "measured": lambda: [measured.run(row) for row in range(plan.rows)],
    }
    rates = _rates(work, size.small, size.rounds)
    long_rate = _rates({"": lambda: [longer.run(row) for row in range(longer_plan.rows)]}, longer_runs, size.rounds)[""]
    if peers:
        from benchmarks.peers import agents_in_space

        mesa = lambda: agents_in_space.batch(size.robots, SPACING_MM, size.peer, STEPS)  # noqa: E731
        rates |= _rates({"mesa": mesa}, size.peer, size.rounds)
    what = f"{size.robots} robots for {STEPS} steps"
    name = agents_in_space.NAME if peers else ""
    return [
        Row(what, "runs/s", rates["bare"], f"{name} batch_run" if peers else "", rates.get("mesa")),
        Row(f"{size.robots} robots for {LONGER * STEPS} steps", "runs/s", long_rate),
        Row(f"{what}, kept", "runs/s", rates["kept"], "not kept", rates["bare"] if peers else None),
        Row(
            f"{what}, measured each step", "runs/s", rates["measured"], "not measured", rates["bare"] if peers else None
        ),
    ]


def _summary(size: Size) -> Row:
    opened = little_model(1)
    (advance,) = (one for one in opened.mission.programs[0].vertices if one.element == "Wheel.Advance")
    asked = StudyRequest(
        [(f"go.{advance.id}.speed", f"1:{POINTS}:1")],
        seeds=f"1-{size.rows // POINTS}",
        measures=["seconds,done,collisions,distance"],
    )
    plan = plan_study(opened, asked)
    with tempfile.TemporaryDirectory() as folder:
        begin_study(Path(folder), plan)
        run_study(Path(folder), _CannedRows())
        study = Study(Path(folder))
        seconds = in_turns({"ours": study.summary}, min(size.rounds, 3))["ours"]
    return Row(f"summary of {size.rows:,} rows".replace(",", " "), "ms", milliseconds(seconds), lower_is_better=True)


def little_model(robots: int) -> OpenMission:
    """So many robots on a grid, as Mesa's stand."""
    starts, agents = [], []
    side = 1
    while side * side < robots:
        side += 1
    for n in range(robots):
        pose = kitrobot.Pose((n % side + 1) * SPACING_MM, (n // side + 1) * SPACING_MM, 0.6 * n)
        starts.append(kitrobot.Start(f"r{n}", pose=pose))
        agents.append(kitrobot.Agent(f"r{n}", "go"))
    world = kitrobot.World("yard", (side + 1) * SPACING_MM, (side + 1) * SPACING_MM, starts=tuple(starts))
    program = kitrobot.read_program(PROGRAM, "mini-robot", "go")
    return kitrobot.open_mission(kitrobot.Mission(programs=[program], team=kitrobot.Team(agents), own_world=world))


class _Hot:
    """An executor whose mission is open already, as in the second batch of a process."""

    def __init__(self, runner: PointRunner) -> None:
        self._runner = runner

    def run(self, work: Work, stop: Callable[[], bool]) -> Iterator[bytes]:
        for row in work.rows:
            yield self._runner.run(row)


class _CannedRows:
    """An executor that makes up its rows."""

    def run(self, work: Work, stop: Callable[[], bool]) -> Iterator[bytes]:
        chance = random.Random(1)
        for row in work.rows:
            ticks = chance.randrange(50, 500)
            measures = {"seconds": ticks / 50, "done": 1, "collisions": ticks % 3, "distance": ticks * chance.random()}
            fields = {"seconds": ticks / 50, "ticks": ticks, "measures": measures}
            yield row_bytes(work.plan, row, "done", "Done after 1.0 s: every program has ended.", fields)


def _kept(plan: Plan, runner: PointRunner) -> None:
    with tempfile.TemporaryDirectory() as folder:
        begin_study(Path(folder), plan)
        run_study(Path(folder), _Hot(runner))


def _rates(work: dict[str, Callable[[], object]], amount: int, rounds: int) -> dict[str, Rate]:
    return {name: Rate.of(amount, taken) for name, taken in in_turns(work, rounds).items()}
