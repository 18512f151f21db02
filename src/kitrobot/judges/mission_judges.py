"""Asks judges of a mission for their word on properties: the check, one run, many runs, every failure.

Each judge is what its own command is (`verify`, `run --watch`, `probability`, `run --fail-sweep`); here all answer in
one form, so that their words can be compared.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace

from kitrobot.checking.verification import VerificationError, VerificationOptions, verify
from kitrobot.checking.verification_result import Finding, Verification
from kitrobot.experiments.run_question import OUTCOMES, RunJudge
from kitrobot.judges.judgement import Judge, JudgeAnswer, JudgeError, Judgement
from kitrobot.judges.many_runs import FailureOptions, judge_failures, judge_runs
from kitrobot.mission.property_text import PropertyText, read_property
from kitrobot.text.phrases import listed, shown
from kitrobot.text.sentences import COMMA, Sentence, Series
from kitrobot.verifier.model.programs import AbstractionError
from kitrobot.verifier.model.timing import Timing
from kitrobot.verifier.properties.conditions import PropertyError
from kitrobot.verifier.properties.verdicts import Answer
from kitrobot.workspace.mission_run import PreparedRun

MISSION_JUDGES = (Judge.CHECK, Judge.RUN, Judge.RUNS, Judge.FAILURES)
"""Those that can be asked of a mission."""
USUAL_RUNS = 100


@dataclass(frozen=True, slots=True)
class JudgeOptions:
    """What is chosen for judges.

    Attributes:
        judges: those that are asked.
        timings: the assumptions of the check.
        check_seconds: at most so long for the check of one property.
        states: at most so many states in the check; None for as many as there is time and memory for.
        approximate: whether the check forgets states to look at more; then nothing that it does not find is kept.
        runs: of many runs, how many.
        failures: at how many moments robots fail, and in how many processes; also of many runs.
        stop: asked now and then whether to break off.
    """

    judges: tuple[Judge, ...] = MISSION_JUDGES
    timings: tuple[Timing, ...] = (Timing.LOCKSTEP,)
    check_seconds: float = 60.0
    states: int | None = None
    approximate: bool = False
    runs: int = USUAL_RUNS
    failures: FailureOptions = field(default_factory=FailureOptions)
    stop: Callable[[], bool] = lambda: False


def judge_options(
    judges: Sequence[str],
    timings: Sequence[str],
    check_seconds: float,
    runs: int,
    moments: int,
    jobs: int | None,
    *,
    approximate: bool = False,
) -> JudgeOptions:
    """The options by the names of judges and timings, each known.

    Raises:
        JudgeError: a name is not known, or a number makes no sense.
    """
    for names, known in (
        (judges, [one.value for one in MISSION_JUDGES]),
        (timings, [one.value for one in Timing]),
    ):
        unknown = next((name for name in names if name not in known), None)
        if unknown is not None:
            message = Sentence("expected one of {known}, found {found}", listed(known), shown(str(unknown)))
            raise JudgeError(message)
    if not (math.isfinite(check_seconds) and check_seconds > 0):
        raise JudgeError(Sentence("a check takes more than 0 seconds"))
    return JudgeOptions(
        tuple(one for one in MISSION_JUDGES if one.value in judges),
        tuple(one for one in Timing if one.value in timings),
        check_seconds,
        approximate=approximate,
        runs=runs,
        failures=FailureOptions(moments, jobs),
    )


def judge_mission(prepared: PreparedRun, questions: Sequence[str], options: JudgeOptions) -> Iterator[Judgement]:
    """What judges say of properties of a mission, one after the other; the run needs a time limit.

    Args:
        prepared: the mission, with the seed and the chance of failures of its first run.
        questions: properties as text, or names of those of the mission; none for all of its own.
        options: who is asked, and for how long.

    Raises:
        QuestionError: a question cannot be understood, or the mission has no such property.
        PropertyError: a condition cannot be understood, or names something that does not exist.
        JudgeError: a number of the options makes no sense.
    """
    texts = list(questions) or [one.name for one in prepared.opened.mission.properties]
    questions_read = [read_property(text) for text in texts]
    # Whoever asks for nonsense hears it at once, and not from some judges.
    judges = [RunJudge(question, prepared.spec) for question in questions_read]
    checked = _CheckCache(prepared, questions_read, options)
    for question, judge in zip(questions_read, judges, strict=True):
        for name in options.judges:
            if name is Judge.CHECK:
                yield checked.judgement(question, judge.words)
            elif name is Judge.RUN:
                yield _judge_run(prepared, question, judge, options)
            elif name is Judge.RUNS:
                yield judge_runs(prepared, question, options.runs, options.failures.jobs, options.stop)
            elif name is Judge.FAILURES:
                yield judge_failures(prepared, question, options.failures, options.stop)


def _judge_run(prepared: PreparedRun, question: PropertyText, judge: RunJudge, options: JudgeOptions) -> Judgement:
    seed = prepared.spec.seed
    answer = judge.answer(seed, options.stop)
    made = _judgement(Judge.RUN, prepared, question, judge.words)
    if answer is None:
        return replace(made, reason=Sentence("it was broken off"))
    made = replace(made, tick_ms=judge.tick_ms, seed=seed)
    return made.kept_at(answer.tick) if answer.holds else made.broken_at(answer.tick)


_Refusal = (PropertyError, AbstractionError, VerificationError)


class _CheckCache:
    """The check of several properties: one exploration for all of them, when the first one is asked for."""

    def __init__(self, prepared: PreparedRun, questions: Sequence[PropertyText], options: JudgeOptions) -> None:
        self._prepared, self._options = prepared, options
        self._questions = [one for one in questions if _check_refusal(prepared, one) is None]
        self._found: Verification | None = None
        self._refusals: dict[str, Sentence] = {}
        """Of questions that turned out to be none for a check: why."""

    def judgement(self, question: PropertyText, words: Sentence) -> Judgement:
        """What the check says of one of the properties."""
        made = _judgement(Judge.CHECK, self._prepared, question, words)
        refusal = _check_refusal(self._prepared, question)
        if refusal is not None:
            return replace(made, reason=refusal)
        self._explore_once()
        if question.text in self._refusals:
            return replace(made, reason=self._refusals[question.text])
        assert self._found is not None, "what is not refused was checked"
        return _of_check(made, self._found, question.name or question.text)

    def _explore_once(self) -> None:
        if self._found is not None or all(one.text in self._refusals for one in self._questions):
            return
        try:
            self._found = self._verify(self._questions)
        except _Refusal as error:
            if len(self._questions) == 1:
                self._refusals[self._questions[0].text] = error.message
                return
            # One of them cannot be checked; that is known before anything is explored.
            for one in self._questions:
                try:
                    self._verify([one], is_tried=True)
                except _Refusal as refused:
                    self._refusals[one.text] = refused.message
            rest = [one for one in self._questions if one.text not in self._refusals]
            if rest:
                self._found = self._verify(rest)

    def _verify(self, questions: Sequence[PropertyText], *, is_tried: bool = False) -> Verification:
        """The check of these; `is_tried`: of one state, to see whether they can be asked."""
        options = self._options
        return verify(
            self._prepared,
            VerificationOptions(
                tuple(one.name for one in questions if one.name),
                options.timings,
                states=1 if is_tried else options.states,
                seconds=options.check_seconds * len(questions),
                confirms=not is_tried,
                stop=options.stop,
                explains=not is_tried,
                approximate=options.approximate,
                asked=tuple(replace(one.asked, name=one.text) for one in questions if one.asked is not None),
            ),
        )


def _check_refusal(prepared: PreparedRun, question: PropertyText) -> Sentence | None:
    """Why a check cannot be asked that at all; None if it can."""
    asked = question.asked or next(
        (one for one in prepared.opened.mission.properties if one.name == question.name), None
    )
    if (asked is not None and asked.counts_seconds) or question.within_s is not None:
        return Sentence("it counts seconds, and the states of a check have none")
    if asked is None and question.name in OUTCOMES:
        return Sentence("an outcome is of runs; a check is asked for properties")
    return None


def _of_check(made: Judgement, found: Verification, name: str) -> Judgement:
    """One word on all assumptions that were checked."""
    broken: Finding | None = None
    answers: set[Answer] = set()
    for column in found.columns:
        for finding in column.findings:
            if finding.verdict.property.name != name:
                continue
            answers.add(finding.verdict.answer)
            is_broken = finding.verdict.answer is Answer.BROKEN
            if is_broken and (broken is None or (broken.confirmed is None and finding.confirmed is not None)):
                broken = finding
    if broken is not None and broken.why is not None:
        made = replace(made, why=broken.why.sentences)
    states = sum(column.judged.states for column in found.columns)
    timings = ", ".join(column.judged.timing.value for column in found.columns)
    if broken is not None and broken.confirmed is not None:
        run = broken.confirmed
        reason = Sentence(
            "an order of events breaks it, and so does the run with seed {seed}, at {seconds} s",
            *(run.seed, f"{run.tick * found.tick_ms / 1000:.2f}"),
        )
        faults = tuple((one.tick, one.agent, one.kind) for one in run.faults)
        return replace(
            made,
            ruling=JudgeAnswer.BROKEN,
            reason=reason,
            tick=run.tick,
            tick_ms=found.tick_ms,
            seed=run.seed,
            faults=faults,
        )
    if broken is not None:
        reason = Sentence("an order of events of the model breaks it; no run that was tried shows it")
        return replace(made, ruling=JudgeAnswer.BROKEN, reason=reason)
    if Answer.NOTHING_FOUND in answers:
        reason = Sentence("nothing found in {states} states by an approximate search, which is no proof", f"{states:,}")
        return replace(made, reason=reason)
    if Answer.NOT_DECIDED in answers:
        return replace(made, reason=Sentence("an approximate check cannot decide it; ask for an exact one, or runs"))
    if Answer.NOT_FINISHED in answers or not answers:
        return replace(made, reason=Sentence("nothing found in {states} states, and there are more", f"{states:,}"))
    if answers == {Answer.VACUOUS}:
        return replace(
            made,
            ruling=JudgeAnswer.KEPT,
            reason=Sentence("what it is about never comes, in {states} states", f"{states:,}"),
        )
    reason = Sentence("kept in every order of events, {states} states ({timings})", f"{states:,}", timings)
    if found.limits:
        reason = Sentence("{reason}; it is taken for granted: {limits}", reason, Series(COMMA, found.limits))
    return replace(made, ruling=JudgeAnswer.KEPT, reason=reason)


def _judgement(judge: Judge, prepared: PreparedRun, question: PropertyText, words: Sentence) -> Judgement:
    return Judgement(judge, prepared.opened.name, question.text, words, JudgeAnswer.NOT_DECIDED, Sentence(""))
