"""How probable something is that hardly ever happens in a run, by multilevel splitting (`branch_estimate`).

A run goes up levels as it counts something: boxes that are brought, robots that have failed, contacts. Branches of it
begin where a level is passed, each with other chance from there on, so that many come near what is asked for. Every
question can be asked, by any of them; the estimate is unbiased, and precise where the count leads there.

Repetitions have numbers, and each is decided by its number and the seed: the result does not depend on the number of
processes. A branch has the chance of several seeds, so unlike a run of `probability` it has no seed to look at it by.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any, Final

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.experiments.probability import Progress
from kitrobot.experiments.run_question import RunProperty, find_run_property, with_time_of
from kitrobot.experiments.statistics.branch_estimate import (
    MOST_LEVELS,
    USUAL_REPETITIONS,
    BranchEnd,
    Repetition,
    find_levels,
    plan_effort,
    split,
    split_interval,
)
from kitrobot.experiments.statistics.interval import USUAL_CONFIDENCE, Interval, check_confidence
from kitrobot.mission.property_text import PropertyText, read_property
from kitrobot.sim.run_branch import branch_run, lasting_draws
from kitrobot.sim.run_spec import RunSpec
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.tables.columns import DOWN, FAILED
from kitrobot.sim.tables.state import numbers
from kitrobot.text.phrases import one_of
from kitrobot.text.sentences import Sentence
from kitrobot.text.suggestions import did_you_mean
from kitrobot.verifier.report.replay import RunObserver
from kitrobot.workspace.child_processes import check_jobs, cores
from kitrobot.workspace.mission_run import PreparedRun
from kitrobot.workspace.task_pool import run_tasks

USUAL_BRANCHES: Final = 10_000
PILOT: Final = 40
"""Branches from each level of the pilot."""
_STRETCH: Final = 50
"""Steps between two looks at the level, at most."""

LEVELS: Final[dict[str, Callable[[Simulation], int]]] = {
    "delivered": lambda run: sum(run.delivered.values()),
    "failed": lambda run: sum(one == FAILED for one in numbers(run.state.robots.ints[DOWN])),
    "collisions": lambda run: run.collisions,
}
"""What can be counted on the way, by name: boxes brought, robots that have failed, beginnings of contacts."""


def likely_count(prepared: PreparedRun) -> str | None:
    """The count that most likely leads to something rare in a run, of `LEVELS`; None where runs are not split."""
    run = prepared.simulation
    if lasting_draws(run):
        return None
    if prepared.spec.fail_rate > 0:
        return "failed"
    if len(run.members) > 1:
        return "collisions"
    return "delivered" if run.total > 0 else None


class SplittingError(KitRobotError):
    """A run cannot be split as it was asked for."""


@dataclass(frozen=True, slots=True)
class SplittingOptions:
    """What is chosen beside the mission and its run.

    Attributes:
        counts: what levels count, of `LEVELS`.
        branches: how many are run at most, those of the pilot not among them.
        repetitions: independent estimates that the interval is made of, at least 2.
        confidence: how often the interval is right, between 0 and 1.
        jobs: over how many processes repetitions are shared out (1 to `MOST_JOBS`); None: one for each core.
    """

    counts: str
    branches: int = USUAL_BRANCHES
    repetitions: int = USUAL_REPETITIONS
    confidence: float = USUAL_CONFIDENCE
    jobs: int | None = None


@dataclass(frozen=True, slots=True)
class RareProbability:
    """What came of it.

    Attributes:
        question: as it was asked.
        words: what is asked, in a sentence.
        options: what was chosen.
        seed, fail_rate: what decides all chance; of all branches.
        levels: those that were found to be worth it, ascending.
        passed: of each level, the share of branches from the one before that passed it.
        repetitions: the estimates.
        branches: how many were counted.
        complete: whether no repetition is missing, as of what was broken off.
        interval: for the probability; None where too few repetitions found what is asked for.
        real_seconds: how long it took on the clock on the wall.
    """

    question: str
    words: Sentence
    options: SplittingOptions
    seed: int
    fail_rate: float
    levels: tuple[float, ...]
    passed: tuple[float, ...]
    repetitions: tuple[float, ...]
    branches: int
    complete: bool
    interval: Interval | None
    real_seconds: float

    def to_json(self) -> dict[str, Any]:
        """As plain values, in the published shape."""
        interval = self.interval
        return {
            "question": self.question,
            "sentence": str(self.words),
            "splitting": self.options.counts,
            "levels": [int(level) for level in self.levels],
            "passed": [round(share, 6) for share in self.passed],
            "branches": self.branches,
            "repetitions": list(self.repetitions),
            "seed": self.seed,
            "fail_rate": self.fail_rate,
            "confidence": self.options.confidence,
            "method": str(interval.method) if interval is not None else "none",
            "complete": self.complete,
            "estimate": None if interval is None else interval.estimate,
            "low": None if interval is None else interval.low,
            "high": None if interval is None else interval.high,
            "timing": {"real_seconds": round(self.real_seconds, 3)},
        }


class _BranchRunner:
    """Runs the branches of a mission's runs, one after the other, in one simulation."""

    def __init__(self, question: PropertyText, spec: RunSpec, counts: str) -> None:
        self._run = run = with_time_of(question, spec).simulation()
        self._property: RunProperty = find_run_property(question, run)
        self.words: Sentence = self._property.words
        self._level = LEVELS[counts]
        self._observer = RunObserver(self._property.property, run)
        self._beginning = run.snapshot(), self._observer.memory()
        self._expect_levels(counts)

    def branch(self, state: Any, level: float, seed: int) -> BranchEnd:
        """Goes on from a state to a level or the end (see `branch_estimate.Branch`)."""
        run, observer = self._run, self._observer
        snapshot, memory = state if state is not None else self._beginning
        branch_run(run, snapshot, seed)
        observer.remember(memory)
        while self._level(run) < level:
            run.advance(min(observer.steps, _STRETCH))
            if observer.violation() >= 0:
                return self._end(True)
            if observer.is_kept:
                return self._end(False)
            if run.outcome is not None:
                return self._end(observer.is_broken_by_end(run.outcome))
        return BranchEnd((run.snapshot(), observer.memory()))

    def _end(self, is_broken: bool) -> BranchEnd:
        return BranchEnd(None, is_broken == self._property.is_reversed)

    def _expect_levels(self, counts: str) -> None:
        lasting = lasting_draws(self._run)
        if lasting:
            agent, sensor = lasting[0]
            raise SplittingError(
                Sentence("{sensor} of {agent} keeps its chance for a while, so a run is not split", sensor, agent),
                Sentence("ask without splitting"),
            )
        if counts == "delivered" and not self._run.total:
            raise SplittingError(
                Sentence("there is nothing to deliver in this mission, so runs are not split at that"),
                Sentence("split them at `failed` or `collisions`"),
            )


def find_rare_probability(
    prepared: PreparedRun,
    question: str,
    options: SplittingOptions,
    progress: Progress | None = None,
    stop: Callable[[], bool] = lambda: False,
) -> RareProbability:
    """Estimates how probable it is that a run of a mission has a property, by splitting; it needs a time limit.

    Ctrl-C (KeyboardInterrupt) among the repetitions, or `stop`, ends them: what was found until then is given.

    Raises:
        QuestionError, PropertyError: the question cannot be understood, or the mission has no such property.
        SplittingError: runs cannot be split at this count, or it has no levels.
        StatisticsError, JobsError: a number of the options makes no sense.
        PoolError: a process died.
    """
    began = time.perf_counter()
    _check(options)
    asked, spec = read_property(question), prepared.spec
    runner = _BranchRunner(asked, spec, options.counts)
    levels = find_levels(runner.branch, MOST_LEVELS, PILOT, spec.seed)
    if not levels:
        raise SplittingError(
            Sentence(
                "runs have no levels of `{counts}`: of {count} branches most pass each one, or none the first",
                options.counts,
                PILOT,
            ),
            Sentence("split them at another count, or ask without splitting"),
        )
    effort = plan_effort(options.branches, len(levels), options.repetitions)
    found: dict[int, Repetition] = {}
    try:
        for number, one in _repetitions(runner, asked, spec, options, levels, effort, stop):
            found[number] = one
            if progress is not None:
                progress(len(found), options.repetitions)
    except KeyboardInterrupt:
        pass
    ordered = [found[number] for number in sorted(found)]
    return RareProbability(
        asked.text,
        runner.words,
        options,
        spec.seed,
        spec.fail_rate,
        levels,
        tuple(sum(one.passed[at] for one in ordered) / max(1, len(ordered)) for at in range(len(levels))),
        tuple(one.estimate for one in ordered),
        sum(one.branches for one in ordered),
        len(ordered) == options.repetitions,
        split_interval(ordered, options.confidence),
        time.perf_counter() - began,
    )


def _check(options: SplittingOptions) -> None:
    check_confidence(options.confidence)
    if options.counts not in LEVELS:
        raise SplittingError(
            Sentence("runs are split at {known}, not at `{counts}`", one_of(LEVELS), options.counts),
            did_you_mean(options.counts, LEVELS),
        )
    check_jobs(options.jobs)
    if options.repetitions < 2:
        raise SplittingError(Sentence("an interval needs 2 repetitions at least"))
    plan_effort(options.branches, 1, options.repetitions)


def _repetitions(
    runner: _BranchRunner,
    asked: PropertyText,
    spec: RunSpec,
    options: SplittingOptions,
    levels: tuple[float, ...],
    effort: int,
    stop: Callable[[], bool],
) -> Iterator[tuple[int, Repetition]]:
    """The repetitions with their numbers, as they come."""
    wanted = range(options.repetitions)
    jobs = options.jobs or cores()
    if jobs < 2:
        for number in wanted:
            if stop():
                return
            yield number, split(runner.branch, levels, effort, spec.seed, number)
        return
    yield from run_tasks(_work, wanted, jobs, _begin, (asked, spec, options.counts, levels, effort), stop)


_here: list[Any] = []
"""Of a process of the pool: what runs its branches, the seed, the levels, and the branches from each."""


def _begin(
    asked: PropertyText, spec: RunSpec, counts: str, levels: tuple[float, ...], effort: int, leave_off: Any
) -> None:
    """In a process of the pool, once."""
    _here[:] = [_BranchRunner(asked, spec, counts), spec.seed, levels, effort]


def _work(number: int) -> tuple[int, Repetition]:
    runner, seed, levels, effort = _here
    return number, split(runner.branch, levels, effort, seed, number)
