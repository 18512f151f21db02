"""A fail sweep of a mission: every agent, or every two agents, fail at each of so many moments, and what comes of it.

The mission is run once without these failures (the baseline), then once for each field (`sim.sweep`), over the cores of
this machine in one pool of processes. What they are given is compiled already. The result is the same whatever their
number: fields are sorted, and nothing that the clock on the wall decides is in them but `real_seconds`.
"""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any, Final

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.sim.jit.policy import expect_many_runs, would_gain
from kitrobot.sim.outcome import Outcome
from kitrobot.sim.run_spec import RunSpec
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.sweep import (
    MOST_MOMENTS,
    Fault,
    Field,
    SweepStoppedError,
    Task,
    moments_of,
    run_task,
    snapshots_at,
)
from kitrobot.text.sentences import Sentence
from kitrobot.workspace.child_processes import check_jobs, cores
from kitrobot.workspace.mission_run import PreparedRun, Run
from kitrobot.workspace.task_pool import run_tasks

OUTCOMES: Final[tuple[Outcome, ...]] = ("done", "failed", "stuck", "time")
MOST_FIELDS: Final = 1_000_000

Progress = Callable[[int, int], None]
"""Told how many fields are over, and how many there are."""


def _never() -> bool:
    return False


class SweepError(KitRobotError):
    """A sweep that makes no sense."""


@dataclass(frozen=True)
class SweepOptions:
    """What is chosen for a sweep: at how many moments agents fail (1 to `MOST_MOMENTS`), whether two at a time, and
    over how many processes fields are shared out (1 to `MOST_JOBS`; None: one for each core).
    """

    moments: int = 100
    pairs: bool = False
    jobs: int | None = None


@dataclass(frozen=True)
class Sweep:
    """What came of a sweep.

    Attributes:
        agents: the names of all agents, in team order.
        tick_ms: a step of the simulator.
        baseline: the run without these failures.
        moments: when agents failed, in steps, ascending.
        fields: the runs that are over, in order of their failures: agent and moment of the first, then of the second.
        total: how many fields there are; more than `fields` of a sweep that was broken off.
        pairs: whether two failed in each.
        real_seconds: how long it took on the clock on the wall.
    """

    agents: tuple[str, ...]
    tick_ms: int
    baseline: Run
    moments: tuple[int, ...]
    fields: tuple[Field, ...]
    total: int
    pairs: bool
    real_seconds: float

    @property
    def complete(self) -> bool:
        """Whether every field is over."""
        return len(self.fields) == self.total

    @property
    def counts(self) -> dict[Outcome, int]:
        """How many fields had which outcome."""
        found = Counter(field.outcome for field in self.fields)
        return {outcome: found[outcome] for outcome in OUTCOMES}

    @property
    def holds(self) -> bool:
        """Whether it is complete and every field was done; of pairs: done, or failed with the reason."""
        accepted = ("done", "failed") if self.pairs else ("done",)
        return self.complete and all(field.outcome in accepted for field in self.fields)

    @property
    def would_gain(self) -> bool:
        """Whether it was long, and would have been much quicker if Numba were installed."""
        return would_gain(len(self.fields) * self.baseline.ticks * len(self.agents))

    def seconds(self, tick: int) -> float:
        """Simulated time at a step."""
        return tick * self.tick_ms / 1000

    def to_json(self) -> dict[str, Any]:
        """As plain values, in the published shape."""
        baseline = self.baseline.to_json()
        del baseline["timing"]
        return {
            "agents": list(self.agents),
            "pairs": self.pairs,
            "moments": [self.seconds(tick) for tick in self.moments],
            "baseline": baseline,
            "total": self.total,
            "complete": self.complete,
            "counts": self.counts,
            "fields": [
                {
                    "failures": [
                        {"agent": self.agents[fault.agent], "at": self.seconds(fault.tick)} for fault in field.faults
                    ],
                    "outcome": field.outcome,
                    "seconds": self.seconds(field.ticks),
                    "sentence": field.sentence,
                }
                for field in self.fields
            ],
            "timing": {"real_seconds": round(self.real_seconds, 3)},
        }


def run_sweep(
    prepared: PreparedRun,
    options: SweepOptions,
    progress: Progress | None = None,
    stop: Callable[[], bool] = _never,
) -> Sweep:
    """Runs a mission once as it is and then every field, once; the run needs a time limit and is not recorded.

    Ctrl-C (KeyboardInterrupt) among the fields, or `stop`, ends the sweep: what was found until then is given.

    Raises:
        SweepError, JobsError: a number of the options makes no sense.
        PoolError: a process died.
        SweepStoppedError: `stop` said so before the first field.
    """
    _check(options)
    began = time.perf_counter()
    simulation = prepared.again()
    baseline = prepared.run(lambda _: _go_on(stop))
    agents = range(len(simulation.members))
    moments = moments_of(baseline.ticks, options.moments)
    total = _total(len(agents), len(moments), options.pairs)
    if total > MOST_FIELDS:
        raise SweepError(
            Sentence("this sweep has {total} fields; at most {most} are run", total, MOST_FIELDS),
            Sentence("choose fewer moments"),
        )
    snapshots = snapshots_at(simulation, moments, stop)
    tasks = [
        _task(agent, n, moments, snapshots, len(agents), options.pairs) for n in range(len(moments)) for agent in agents
    ]
    tasks = [task for task in tasks if task.size]
    fields: list[Field] = []
    try:
        work = total * baseline.ticks * len(agents)
        for found in _run(prepared, simulation, tasks, options.jobs or cores(), work, stop):
            fields += found
            if progress is not None:
                progress(len(fields), total)
    except (KeyboardInterrupt, SweepStoppedError):
        pass
    fields.sort(key=lambda field: [(fault.agent, fault.tick) for fault in field.faults])
    names = tuple(agent.name for agent in simulation.members)
    real = time.perf_counter() - began
    return Sweep(names, simulation.tick_ms, baseline, moments, tuple(fields), total, options.pairs, real)


def _go_on(stop: Callable[[], bool]) -> None:
    if stop():
        raise SweepStoppedError(Sentence("the sweep was broken off"))


def _check(options: SweepOptions) -> None:
    if not 1 <= options.moments <= MOST_MOMENTS:
        raise SweepError(Sentence("a sweep has from 1 to {most} moments", MOST_MOMENTS))
    check_jobs(options.jobs)


def _total(agents: int, moments: int, pairs: bool) -> int:
    return agents * (agents - 1) // 2 * moments**2 if pairs else agents * moments


def _task(
    agent: int, number: int, moments: Sequence[int], snapshots: dict[int, bytes], agents: int, pairs: bool
) -> Task:
    tick = moments[number]
    if not pairs:
        return Task(Fault(agent, tick), snapshots[tick])
    return Task(Fault(agent, tick), snapshots[tick], tuple(range(agents)), tuple(moments[number:]))


def _run(
    prepared: PreparedRun,
    simulation: Simulation,
    tasks: Sequence[Task],
    jobs: int,
    work: int,
    stop: Callable[[], bool],
) -> Iterator[list[Field]]:
    """The fields of each task, as they come; `work` is about how many steps of one robot all of them are."""
    jobs = min(jobs, len(tasks))
    if jobs < 2:
        for task in tasks:
            yield list(run_task(simulation, task, stop))
        return
    is_plain = not expect_many_runs(work)
    yield from run_tasks(_work, tasks, jobs, _begin, (prepared.spec, is_plain), stop)


_here: list[Any] = []
"""Of a process of the pool: its simulation, and the event at which it is to leave off."""


def _begin(spec: RunSpec, is_plain: bool, stop: Any) -> None:
    """In a process of the pool, once."""
    _here[:] = [spec.simulation(), stop]
    _here[0].stays_plain = is_plain


def _work(task: Task) -> list[Field]:
    simulation, stop = _here
    try:
        return list(run_task(simulation, task, stop.is_set))
    except SweepStoppedError:
        return []
