"""How probable it is that a run of a mission has a property: as many runs as it takes, and an interval that holds.

Runs have the seeds s, s + 1, s + 2, …, and are counted in this order, whoever ran them; so the result does not depend
on the number of processes, and each run can be looked at with `kitrobot run --seed`.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Generator, Iterator
from contextlib import closing
from dataclasses import dataclass
from typing import Any, Final, TypedDict

from kitrobot.experiments.run_question import RunAnswer, RunJudge
from kitrobot.experiments.statistics.interval import USUAL_CONFIDENCE, Interval, StatisticsError
from kitrobot.experiments.statistics.ratio_test import RatioTest
from kitrobot.experiments.statistics.stopping_rule import LookPlan, SequentialShare, hoeffding_runs, plan_looks
from kitrobot.mission.property_text import PropertyText, read_property
from kitrobot.sim.jit.policy import expect_many_runs
from kitrobot.sim.run_spec import RunSpec
from kitrobot.sim.setup.limits import MAX_SEED
from kitrobot.text.sentences import Sentence
from kitrobot.workspace.child_processes import check_jobs, cores
from kitrobot.workspace.mission_run import PreparedRun
from kitrobot.workspace.task_pool import run_tasks

USUAL_PRECISION: Final = 0.05
_BATCH: Final = 8
"""Runs that a process is given at once."""
_SHOWN: Final = 3
"""Runs that are kept of each answer."""
_RARE_SHARE: Final = 0.01
_RARE_RUNS: Final = 50
"""What holds in at most that share of so many runs, or of more, is rare."""
_FEW: Final = 100
"""Runs that a test of *at least* is taken to need."""

Progress = Callable[[int, int | None], None]
"""Told how many runs are counted, and how many there are at most, where that is known."""


class RunLimits(TypedDict, total=False):
    """What limits the runs of `kitrobot.probability`."""

    seconds: float
    runs: int | None
    jobs: int | None
    progress: Progress | None


def _never() -> bool:
    return False


@dataclass(frozen=True, slots=True)
class ProbabilityOptions:
    """What is chosen beside the mission and its run.

    Attributes:
        precision: how far the probability may be from the estimate, or makes no difference to *at least*.
        confidence: how often the answer is right, between 0 and 1.
        at_least: only decide whether the probability is at least this; None: estimate it.
        most_runs: at most so many runs; None: as many as it takes.
        jobs: over how many processes runs are shared out (1 to `MOST_JOBS`); None: one for each core.
    """

    precision: float = USUAL_PRECISION
    confidence: float = USUAL_CONFIDENCE
    at_least: float | None = None
    most_runs: int | None = None
    jobs: int | None = None


@dataclass(frozen=True, slots=True)
class Probability:
    """What came of it.

    Attributes:
        question: as it was asked.
        words: what is asked, in a sentence.
        options: what was chosen.
        seed, fail_rate: of the first run; of all runs.
        runs, holds: how many runs were counted, and in how many of them it holds.
        complete: whether the rule ended them; not of what was broken off, or of too few runs for a decision.
        interval: for the probability, as far as it is known; None before the first run, and of *at least*.
        looked_at: the runs that it is of.
        planned_runs: the runs of the last look that is planned; None of *at least*.
        decision: whether the probability is at least that; None where that is not asked, or open.
        examples, counterexamples: the first runs in which it holds, and in which it does not.
        tick_ms: a step of the simulator.
        real_seconds: how long it took on the clock on the wall.
    """

    question: str
    words: Sentence
    options: ProbabilityOptions
    seed: int
    fail_rate: float
    runs: int
    holds: int
    complete: bool
    interval: Interval | None
    looked_at: int
    planned_runs: int | None
    decision: bool | None
    examples: tuple[RunAnswer, ...]
    counterexamples: tuple[RunAnswer, ...]
    tick_ms: int
    real_seconds: float

    @property
    def method(self) -> Sentence:
        """What the answer is computed by."""
        if self.options.at_least is not None:
            return Sentence(
                "Wald's sequential probability ratio test, {threshold} ± {precision}",
                f"{self.options.at_least:g}",
                f"{self.options.precision:g}",
            )
        return self.interval.method if self.interval is not None else Sentence("none")

    @property
    def is_rare(self) -> bool:
        """Whether it holds in so few of many runs that splitting (`rare_probability`) would say more with as many."""
        return self.options.at_least is None and self.runs >= _RARE_RUNS and self.holds <= _RARE_SHARE * self.runs

    @property
    def hoeffding_runs(self) -> int:
        """The runs of Chernoff and Hoeffding's bound, which a fixed number of runs needs."""
        return hoeffding_runs(self.options.precision, self.options.confidence)

    def to_json(self) -> dict[str, Any]:
        """As plain values, in the published shape."""
        interval = self.interval
        made: dict[str, Any] = {
            "question": self.question,
            "sentence": str(self.words),
            "runs": self.runs,
            "holds": self.holds,
            "seed": self.seed,
            "fail_rate": self.fail_rate,
            "precision": self.options.precision,
            "confidence": self.options.confidence,
            "method": str(self.method),
            "complete": self.complete,
        }
        if self.options.at_least is not None:
            made |= {"at_least": self.options.at_least, "answer": self.decision}
        else:
            made |= {
                "estimate": None if interval is None else interval.estimate,
                "low": None if interval is None else interval.low,
                "high": None if interval is None else interval.high,
                "looked_at": self.looked_at,
                "planned_runs": self.planned_runs,
                "chernoff_hoeffding_runs": self.hoeffding_runs,
                "rare": self.is_rare,
            }
        return made | {
            "examples": [self._answer_json(one) for one in self.examples],
            "counterexamples": [self._answer_json(one) for one in self.counterexamples],
            "timing": {"real_seconds": round(self.real_seconds, 3)},
        }

    def _answer_json(self, one: RunAnswer) -> dict[str, Any]:
        return {"seed": one.seed, "seconds": one.tick * self.tick_ms / 1000, "sentence": str(one.sentence)}


class _Counts:
    """The answers so far, and the rule that ends them."""

    def __init__(self, options: ProbabilityOptions) -> None:
        self.plan: LookPlan | None = None
        self.share: SequentialShare | None = None
        self.test: RatioTest | None = None
        self.most_runs = options.most_runs
        if options.at_least is None:
            self.plan = plan_looks(options.precision, options.confidence, options.most_runs)
            self.share, self.most_runs = SequentialShare(self.plan), self.plan.most_runs
        else:
            self.test = RatioTest(options.at_least, options.precision, options.confidence)
        self.runs = 0
        self.holding: list[RunAnswer] = []
        self.failing: list[RunAnswer] = []
        self.holds = 0
        self.complete = False

    @property
    def expected_runs(self) -> int:
        """About how many runs there are: of *at least* nobody knows."""
        return self.plan.most_runs // 2 if self.plan is not None else min(_FEW, self.most_runs or _FEW)

    def add(self, answer: RunAnswer) -> bool:
        """Counts the next run; whether it is the last one."""
        self.runs += 1
        self.holds += answer.holds
        shown = self.holding if answer.holds else self.failing
        if len(shown) < _SHOWN:
            shown.append(answer)
        if self.share is not None:
            self.complete = self.share.add(answer.holds)
        elif self.test is not None:
            self.test.add(answer.holds)
            self.complete = self.test.decision is not None
        return self.complete or self.runs == self.most_runs


def find_probability(
    prepared: PreparedRun,
    question: str,
    options: ProbabilityOptions,
    progress: Progress | None = None,
    stop: Callable[[], bool] = _never,
) -> Probability:
    """Runs a mission until it is known how probable something is; the run needs a time limit.

    Ctrl-C (KeyboardInterrupt) among the runs, or `stop`, ends them: what was found until then is given.

    Raises:
        QuestionError, PropertyError: the question cannot be understood, or the mission has no such property.
        StatisticsError, JobsError: a number of the options makes no sense.
        PoolError: a process died.
    """
    began = time.perf_counter()
    check_jobs(options.jobs)
    if options.most_runs is not None and options.most_runs < 1:
        raise StatisticsError(Sentence("there is no run to count"), Sentence("let at least one run end"))
    asked, spec = read_property(question), prepared.spec
    counts = _Counts(options)
    judge = RunJudge(asked, spec)
    try:
        with closing(_answers(judge, asked, spec, counts, options.jobs or cores(), stop)) as answers:
            for answer in answers:
                is_over = counts.add(answer)
                if progress is not None:
                    progress(counts.runs, counts.most_runs)
                if is_over:
                    break
    except KeyboardInterrupt:
        pass
    interval, looked_at = counts.share.known() if counts.share is not None else (None, 0)
    return Probability(
        asked.text,
        judge.words,
        options,
        spec.seed,
        spec.fail_rate,
        counts.runs,
        counts.holds,
        counts.complete,
        interval,
        looked_at,
        counts.plan.most_runs if counts.plan is not None else None,
        counts.test.decision if counts.test is not None else None,
        tuple(counts.holding),
        tuple(counts.failing),
        judge.tick_ms,
        time.perf_counter() - began,
    )


_Batch = tuple[int, int, int]
"""The batch's number, its first seed, and how many runs it has."""


def _answers(
    judge: RunJudge, asked: PropertyText, spec: RunSpec, counts: _Counts, jobs: int, stop: Callable[[], bool]
) -> Generator[RunAnswer, None, None]:
    """What runs answer, in the order of their seeds."""
    first = judge.answer(spec.seed, stop)
    if first is None:
        return
    yield first
    seeds = range(spec.seed + 1, MAX_SEED + 1)
    if counts.most_runs is not None:
        seeds = seeds[: counts.most_runs - 1]
    if jobs < 2 or len(seeds) <= _BATCH:
        for seed in seeds:
            answer = judge.answer(seed, stop)
            if answer is None:
                return
            yield answer
        return
    is_plain = not expect_many_runs(counts.expected_runs * first.tick * judge.robots)
    waiting: dict[int, list[RunAnswer]] = {}
    following = 0
    for number, found in run_tasks(_work, _batches(seeds), jobs, _begin, (asked, spec, is_plain), stop):
        waiting[number] = found
        while following in waiting:
            yield from waiting.pop(following)
            following += 1


def _batches(seeds: range) -> Iterator[_Batch]:
    for number, at in enumerate(range(0, len(seeds), _BATCH)):
        part = seeds[at : at + _BATCH]
        yield number, part[0], len(part)


_here: list[Any] = []
"""Of a process of the pool: its judge, whether it takes plain steps, and the event at which it is to leave off."""


def _begin(asked: PropertyText, spec: RunSpec, is_plain: bool, leave_off: Any) -> None:
    """In a process of the pool, once."""
    _here[:] = [RunJudge(asked, spec), is_plain, leave_off]


def _work(batch: _Batch) -> tuple[int, list[RunAnswer]]:
    judge, is_plain, leave_off = _here
    number, first, size = batch
    found: list[RunAnswer] = []
    for seed in range(first, first + size):
        answer = judge.answer(seed, leave_off.is_set, is_plain)
        if answer is None:
            break
        found.append(answer)
    return number, found
