"""Judges a property by failures: each robot fails at each of so many moments, in a run of its own."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

from kitrobot.experiments.run_question import RunAnswer, RunJudge
from kitrobot.judges.judgement import Judge, JudgeError, Judgement, Ruling
from kitrobot.mission.property_text import PropertyText
from kitrobot.sim.run_spec import RunSpec
from kitrobot.sim.sweep import MOST_MOMENTS, moments_of
from kitrobot.text.sentences import Sentence
from kitrobot.verifier.report.replay import InjectedFault
from kitrobot.workspace.child_processes import MOST_JOBS, cores
from kitrobot.workspace.mission_run import PreparedRun
from kitrobot.workspace.task_pool import run_tasks

USUAL_MOMENTS = 20

_Task = tuple[int, InjectedFault]
_Answer = tuple[int, InjectedFault, RunAnswer | None]


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
        JudgeError: a number of the options makes no sense.
        QuestionError: the mission has no such property.
        PropertyError: a condition cannot be understood, or names something that does not exist.
        PoolError: a process died.
    """
    if not 1 <= options.moments <= MOST_MOMENTS:
        raise JudgeError(Sentence("a sweep has from 1 to {most} moments", MOST_MOMENTS))
    if options.jobs is not None and not 1 <= options.jobs <= MOST_JOBS:
        raise JudgeError(Sentence("runs are shared out over 1 to {most} processes", MOST_JOBS))
    spec = prepared.spec
    judge = RunJudge(question, spec)
    baseline = prepared.again()
    while baseline.outcome is None and not stop():
        baseline.advance(1000)
    moments = moments_of(baseline.tick, options.moments)
    faults = [InjectedFault(tick, agent.name, "fail") for agent in baseline.members for tick in moments]
    answers: dict[int, tuple[InjectedFault, RunAnswer]] = {}
    for number, fault, answer in _answers(judge, question, spec, faults, options.jobs or cores(), stop):
        if answer is not None:
            answers[number] = fault, answer
    broken = [answers[number] for number in sorted(answers) if not answers[number][1].holds]
    made = Judgement(
        *(Judge.FAILURES, prepared.opened.name, question.text, judge.words, Ruling.KEPT),
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
            *(made.judge, made.subject, made.question, made.words, Ruling.BROKEN, reason),
            *(answer.tick, judge.tick_ms, spec.seed, faults_told),
        )
    if len(answers) < len(faults):
        reason = Sentence("broken off after {runs} of {all} runs, all of which keep it", len(answers), len(faults))
        return Judgement(*(made.judge, made.subject, made.question, made.words, Ruling.NOT_DECIDED, reason))
    return made


def _answers(
    judge: RunJudge,
    question: PropertyText,
    spec: RunSpec,
    faults: list[InjectedFault],
    jobs: int,
    stop: Callable[[], bool],
) -> Iterator[_Answer]:
    if jobs < 2 or len(faults) < 2:
        for number, fault in enumerate(faults):
            yield number, fault, judge.answer(spec.seed, stop, faults=(fault,))
        return
    yield from run_tasks(_work, enumerate(faults), min(jobs, len(faults)), _begin, (question, spec), stop)


_here: list[Any] = []
"""Of a process of the pool: its judge, its seed, and the event at which it is to leave off."""


def _begin(question: PropertyText, spec: RunSpec, leave_off: Any) -> None:
    """In a process of the pool, once."""
    _here[:] = [RunJudge(question, spec), spec.seed, leave_off]


def _work(task: _Task) -> _Answer:
    judge, seed, leave_off = _here
    number, fault = task
    return number, fault, judge.answer(seed, leave_off.is_set, faults=(fault,))
