"""Watches a run of the simulator for properties that break, step by step; what breaks is an event of the run."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from kitrobot.experiments.run_question import RunProperty, find_run_property
from kitrobot.judges.judgement import TIME_UP_EARLY, Judge, JudgeAnswer, Judgement, break_text
from kitrobot.mission.property_text import read_question
from kitrobot.sim.event_text import Event
from kitrobot.sim.simulation import Simulation
from kitrobot.text.sentences import Sentence
from kitrobot.verifier.report.replay import RunObserver


@dataclass
class _WatchedProperty:
    question: str
    property: RunProperty
    monitoring: RunObserver
    within_s: float | None
    broken_at: int = -1
    kept_at: int = -1


class RunWatch:
    """Watches a run for properties.

    Args:
        run: a run of the simulator before its first step, with a time limit.
        questions: properties as text, or their names.

    Raises:
        QuestionError: a question cannot be understood, or the mission has no such property.
        PropertyError: a condition cannot be understood, or names something that does not exist.
    """

    def __init__(self, run: Simulation, questions: Sequence[str]) -> None:
        self._run = run
        self._watched: list[_WatchedProperty] = []
        own = [one.name for one in run.mission.properties]
        for text in questions:
            question = read_question(text, own)
            found = find_run_property(question, run)
            self._watched.append(
                _WatchedProperty(question.text, found, RunObserver(found.property, run), question.within_s)
            )

    def after_step(self) -> list[Event]:
        """Looks at the step that was just made; what broke in it."""
        events: list[Event] = []
        for one in self._watched:
            if one.broken_at >= 0 or one.kept_at >= 0:
                continue
            found = one.monitoring.violation()
            if found >= 0:
                one.broken_at = found
                events.append(self._event(one))
            elif one.monitoring.is_kept:
                one.kept_at = one.monitoring.decided_at
            elif self._run.outcome is not None:
                events += self._at_end(one, self._run.outcome)
            elif one.within_s is not None and self._run.seconds >= one.within_s:
                events += self._at_end(one, "time")
        return events

    def _at_end(self, one: _WatchedProperty, outcome: str) -> list[Event]:
        if self._is_early(one):
            return []
        if one.monitoring.is_broken_by_end(outcome) == one.property.is_reversed:
            one.kept_at = self._run.tick
            return []
        one.broken_at = self._run.tick
        return [self._event(one)]

    def _is_early(self, one: _WatchedProperty) -> bool:
        """Whether the time of the run was up before that of a question about its end."""
        run, within_s = self._run, one.within_s
        asks_for_end = "time" in one.property.property.ends_as or one.property.is_reversed
        return asks_for_end and run.outcome == "time" and within_s is not None and run.seconds < within_s

    def _event(self, one: _WatchedProperty) -> Event:
        return Event(self._run.tick, "message", "", break_text(one.question), -1, "program")

    def judgements(self, subject: str) -> list[Judgement]:
        """What is known of each property; `subject` is the name of what runs."""
        return [self._judgement(one, subject) for one in self._watched]

    def _judgement(self, one: _WatchedProperty, subject: str) -> Judgement:
        run = self._run
        reason = Sentence("the run goes on")
        if self._is_early(one):
            reason = TIME_UP_EARLY
        made = Judgement(
            Judge.RUN,
            subject,
            one.question,
            one.property.words,
            JudgeAnswer.NOT_DECIDED,
            reason,
            -1,
            run.tick_ms,
            run.seed,
        )
        if one.broken_at >= 0:
            return made.broken_at(one.broken_at)
        if one.kept_at >= 0:
            if run.outcome is None or one.kept_at < run.tick:
                return made.kept_at(one.kept_at)
            return replace(made, ruling=JudgeAnswer.KEPT, reason=Sentence("kept in this run, to its end"))
        return made
