"""Judges a property by many runs: with other seeds, or with each robot failing at each of so many moments."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any

from kitrobot.experiments.run_question import RunAnswer, RunJudge
from kitrobot.experiments.statistics.shares import share_interval
from kitrobot.judges.judgement import Judge, JudgeAnswer, JudgeError, Judgement
from kitrobot.mission.property_text import PropertyText
from kitrobot.sim.run_spec import RunSpec
from kitrobot.sim.setup.limits import MAX_SEED
from kitrobot.sim.sweep import MOST_MOMENTS, moments_of
from kitrobot.text.sentences import Sentence
from kitrobot.verifier.report.replay import InjectedFault
from kitrobot.workspace.child_processes import check_jobs, cores
from kitrobot.workspace.mission_run import PreparedRun
from kitrobot.workspace.task_pool import run_tasks

USUAL_MOMENTS = 20

_Task = tuple[int, int, tuple[InjectedFault, ...]]
"""A run: its number, its seed, and what is done to robots."""
_Answer = tuple[int, RunAnswer | None]


@dataclass(frozen=True, slots=True)
class FailureOptions:
    """At how many moments robots fail (1 to `MOST_MOMENTS`), and in how many processes; None: one for each core."""

    moments: int = USUAL_MOMENTS
    jobs: int | None = 1


def judge_failures(
    prepared: PreparedRun, question: PropertyText, options: FailureOptions, stop: Callable[[], bool]
) -> Judgement:
    """Judges a property by the failure of each robot at each moment; the run needs a time limit.

    Raises:
        JudgeError, JobsError: a number of the options makes no sense.
        QuestionError: the mission has no such property.
        PropertyError: a condition cannot be understood, or names something that does not exist.
        PoolError: a process died.
    """
    if not 1 <= options.moments <= MOST_MOMENTS:
        raise JudgeError(Sentence("a sweep has from 1 to {most} moments", MOST_MOMENTS))
    check_jobs(options.jobs)
    spec = prepared.spec
    judge = RunJudge(question, spec)
    baseline = prepared.again()
    while baseline.outcome is None and not stop():
        baseline.advance(1000)
    moments = moments_of(baseline.tick, options.moments)
    faults = [InjectedFault(tick, agent.name, "fail") for agent in baseline.members for tick in moments]
    tasks = [(number, spec.seed, (fault,)) for number, fault in enumerate(faults)]
    answers = _answers(judge, question, spec, tasks, options.jobs or cores(), stop)
    broken = [(faults[number], answers[number]) for number in sorted(answers) if not answers[number].holds]
    made = Judgement(
        *(Judge.FAILURES, prepared.opened.name, question.text, judge.words, JudgeAnswer.KEPT),
        Sentence.counted(
            "kept in {count} run with a failure", "kept in {count} runs with a failure each", len(answers)
        ),
        tick_ms=judge.tick_ms,
    )
    if broken:
        fault, answer = broken[0]
        reason = Sentence(
            "broken in {broken} of {runs} runs with a failure, first where {agent} fails at {seconds} s",
            *(len(broken), len(answers), fault.agent, f"{fault.tick * judge.tick_ms / 1000:.2f}"),
        )
        faults_told = ((fault.tick, fault.agent, fault.kind),)
        return Judgement(
            *(made.judge, made.subject, made.question, made.words, JudgeAnswer.BROKEN, reason),
            *(answer.tick, judge.tick_ms, spec.seed, faults_told),
        )
    if len(answers) < len(faults):
        reason = Sentence("broken off after {runs} of {all} runs, all of which keep it", len(answers), len(faults))
        return Judgement(*(made.judge, made.subject, made.question, made.words, JudgeAnswer.NOT_DECIDED, reason))
    return made


def judge_runs(
    prepared: PreparedRun, question: PropertyText, runs: int, jobs: int | None, stop: Callable[[], bool]
) -> Judgement:
    """Judges a property by so many runs, each with the next seed; the run needs a time limit.

    Raises:
        JudgeError, QuestionError, PropertyError, PoolError: as `judge_failures`.
    """
    if runs < 1:
        raise JudgeError(Sentence("there is no run to count"), Sentence("let at least one run end"))
    spec = prepared.spec
    judge = RunJudge(question, spec)
    seeds = range(spec.seed, min(spec.seed + runs, MAX_SEED + 1))
    tasks: list[_Task] = [(number, seed, ()) for number, seed in enumerate(seeds)]
    answers = _answers(judge, question, spec, tasks, jobs or cores(), stop)
    head = (Judge.RUNS, prepared.opened.name, question.text, judge.words)
    if len(answers) < len(tasks):
        return Judgement(*head, JudgeAnswer.NOT_DECIDED, Sentence("it was broken off"))
    broken = [answers[number] for number in sorted(answers) if not answers[number].holds]
    # The number of runs was chosen beforehand, so an interval for a fixed number is one.
    interval = share_interval(len(answers) - len(broken), len(answers), method="exact")
    low, high = f"{interval.low:.3f}", f"{interval.high:.3f}"
    if not broken:
        reason = Sentence("kept in {runs} runs; its probability is {low} to {high}", len(answers), low, high)
        return Judgement(*head, JudgeAnswer.KEPT, reason)
    reason = Sentence(
        "kept in {kept} of {runs} runs, first broken with seed {seed}; its probability is {low} to {high}",
        *(len(answers) - len(broken), len(answers), broken[0].seed, low, high),
    )
    return Judgement(*head, JudgeAnswer.BROKEN, reason, broken[0].tick, judge.tick_ms, broken[0].seed)


def _answers(
    judge: RunJudge,
    question: PropertyText,
    spec: RunSpec,
    tasks: Sequence[_Task],
    jobs: int,
    stop: Callable[[], bool],
) -> dict[int, RunAnswer]:
    """What runs answer, by their numbers; fewer when `stop` said so."""
    found: Iterable[_Answer]
    if jobs < 2 or len(tasks) < 2:
        found = ((number, judge.answer(seed, stop, faults=faults)) for number, seed, faults in tasks)
    else:
        found = run_tasks(_work, tasks, min(jobs, len(tasks)), _begin, (question, spec), stop)
    return {number: answer for number, answer in found if answer is not None}


_here: list[Any] = []
"""Of a process of the pool: its judge, and the event at which it is to leave off."""


def _begin(question: PropertyText, spec: RunSpec, leave_off: Any) -> None:
    """In a process of the pool, once."""
    _here[:] = [RunJudge(question, spec), leave_off]


def _work(task: _Task) -> _Answer:
    judge, leave_off = _here
    number, seed, faults = task
    return number, judge.answer(seed, leave_off.is_set, faults=faults)
