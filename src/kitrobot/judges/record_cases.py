"""Properties that are judged by what is recorded of a run: how each stands, and what is said of it.

A case reads nothing itself: `record_monitor` gives it what was recorded.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from typing import Protocol

from kitrobot.judges.judgement import TIME_UP_EARLY, Judge, JudgeAnswer, Judgement
from kitrobot.judges.recorded_events import breaks_ready_property
from kitrobot.mission.property_forms import AskedProperty, Form
from kitrobot.mission.property_text import PropertyText, words_within
from kitrobot.text.sentences import Sentence
from kitrobot.trace.model import TraceEvent, TraceHeader
from kitrobot.verifier.properties.conditions import AgentCondition
from kitrobot.verifier.properties.properties import Property
from kitrobot.verifier.properties.property_automaton import PropertyAutomaton, PropertyState
from kitrobot.verifier.properties.ready_monitors import waited_long_enough

_SURE_IN_GAPS = (Form.NEVER, Form.AT_MOST)
"""The forms that stay broken whatever happened in ticks that are missing."""
_ROUNDING = 1e-9
"""Of a tick: seconds are decimal numbers."""


@dataclass
class RecordedSpan:
    """What is recorded so far of a run.

    Attributes:
        header: of its recording.
        judge, subject: who judges it, and what is judged.
        last_tick: the last tick that was recorded.
        outcome: how the run ended; None while it goes on, and of a recording without its end.
    """

    header: TraceHeader
    judge: Judge
    subject: str
    last_tick: int = 0
    outcome: str | None = None

    def undecided(self, question: str, words: Sentence, reason: Sentence) -> Judgement:
        """A judgement that says nothing yet."""
        ruling = JudgeAnswer.NOT_DECIDED
        return Judgement(self.judge, self.subject, question, words, ruling, reason, tick_ms=self.header.tick_ms)

    def limit(self, within_s: float) -> int:
        """The last tick of so many seconds, as of a run with that time limit."""
        return max(1, math.ceil(within_s * 1000 / self.header.tick_ms - _ROUNDING))

    def end_within(self, within_s: float | None) -> tuple[int, str | None]:
        """The last tick that counts, and the outcome by then: `time` where the run went on behind so many seconds."""
        if within_s is None:
            return self.last_tick, self.outcome
        limit = self.limit(within_s)
        is_over = self.last_tick > limit or (self.last_tick == limit and self.outcome is None)
        return (limit, "time") if is_over else (self.last_tick, self.outcome)

    def has_end(self, within_s: float | None) -> bool:
        """Whether it is known how the run ended, perhaps within so many seconds."""
        return self.end_within(within_s)[1] is not None

    def is_early(self, within_s: float | None) -> bool:
        """Whether the time of the run was up before so many seconds had passed."""
        return within_s is not None and self.outcome == "time" and self.last_tick < self.limit(within_s)

    def moment(self, tick: int) -> str:
        """The seconds of a tick."""
        return f"{tick * self.header.tick_ms / 1000:.2f}"


class RecordCase(Protocol):
    """A property while it is judged by a recording."""

    def may_be_broken(self, span: RecordedSpan) -> bool:
        """Whether it is worth asking for a judgement, which takes longer than a tick may."""

    def judgement(self, span: RecordedSpan) -> Judgement:
        """What is said of it, of what is recorded so far."""


@dataclass
class UndecidedCase:
    """A property that cannot be judged."""

    question: str
    words: Sentence
    reason: Sentence

    def may_be_broken(self, span: RecordedSpan) -> bool:
        """Never."""
        return False

    def judgement(self, span: RecordedSpan) -> Judgement:
        """What is said of it."""
        return span.undecided(self.question, self.words, self.reason)


@dataclass
class ConditionCase:
    """A property of which conditions are judged."""

    question: str
    asked: AskedProperty
    within_s: float | None
    conditions: list[AgentCondition]
    automaton: PropertyAutomaton
    unknown: str = ""
    """A robot whose values were not recorded, or are not known as they were."""
    gap: int = 0
    """Ticks that were missing when it was decided."""

    @property
    def agents(self) -> list[int]:
        """The numbers of the agents that it speaks of."""
        return sorted({agent for one in self.conditions for agents in one.tests.values() for agent in agents})

    @property
    def is_open(self) -> bool:
        """Whether more ticks may decide it."""
        return not self.unknown and self.automaton.standing is PropertyState.OPEN

    def may_be_broken(self, span: RecordedSpan) -> bool:
        """Whether a tick, or the end, broke it."""
        return self.automaton.standing is PropertyState.BROKEN or span.has_end(self.within_s)

    def judgement(self, span: RecordedSpan) -> Judgement:
        """What is said of it, of what is recorded so far."""
        asked, automaton = self.asked, self.automaton
        words = words_within(asked.words, self.within_s)
        names = tuple(span.header.agents[i].name for i in self.agents)
        made = replace(span.undecided(self.question, words, Sentence("")), agents=names)
        if self.unknown:
            reason = Sentence("what {name} read and stored was not recorded, or its robot has changed", self.unknown)
            return replace(made, reason=reason)
        if automaton.standing is PropertyState.BROKEN:
            if self.gap and asked.form not in _SURE_IN_GAPS:
                return replace(made, reason=self._missing_ticks())
            return made.broken_at(automaton.decided_at)
        if automaton.standing is PropertyState.KEPT:
            if self.gap and asked.form is Form.BEFORE:
                return replace(made, reason=self._missing_ticks())
            return made.kept_at(automaton.decided_at)
        return self._of_end(span, made)

    def _of_end(self, span: RecordedSpan, made: Judgement) -> Judgement:
        """Of a property that was still open when the recording, or the time that is looked at, ended."""
        automaton, (last, outcome) = self.automaton, span.end_within(self.within_s)
        if self.gap:
            return replace(made, reason=self._missing_ticks())
        if not automaton.is_broken_by_end():
            is_over = outcome is not None
            reason = Sentence("kept in this run, to its end") if is_over else Sentence("kept in all that was recorded")
            return replace(made, ruling=JudgeAnswer.KEPT, reason=reason)
        since = span.moment(max(0, automaton.waits_since))
        if outcome is None:
            reason = Sentence("the recording ends, and what is waited for since {seconds} s may still come", since)
            return replace(made, reason=reason)
        if outcome == "time" and automaton.deadline is not None:
            return replace(made, reason=TIME_UP_EARLY)
        if not waited_long_enough(outcome, last, automaton.waits_since):
            reason = Sentence("the time of the run was up, and it waited only since {seconds} s", since)
            return replace(made, reason=reason)
        reason = Sentence("the run ended, and what it waited for since {seconds} s had not come", since)
        return replace(made, ruling=JudgeAnswer.BROKEN, reason=reason, tick=last)

    def _missing_ticks(self) -> Sentence:
        return Sentence.counted(
            "{count} tick was not recorded, and it may have been decided there",
            "{count} ticks were not recorded, and it may have been decided there",
            self.gap,
        )


@dataclass
class OutcomeCase:
    """A run that is to end with an outcome."""

    text: PropertyText

    def may_be_broken(self, span: RecordedSpan) -> bool:
        """Whether the run has ended."""
        return span.has_end(self.text.within_s)

    def judgement(self, span: RecordedSpan) -> Judgement:
        """What is said of it, of what is recorded so far."""
        text = self.text
        words = words_within(Sentence("a run ends with the outcome {outcome}", text.name), text.within_s)
        made = span.undecided(text.text, words, Sentence(""))
        last, outcome = span.end_within(text.within_s)
        if span.is_early(text.within_s):
            return replace(made, reason=TIME_UP_EARLY)
        if outcome is None:
            return replace(made, reason=Sentence("the recording ends before the run does"))
        reason = Sentence("the run ended at {seconds} s with the outcome {outcome}", span.moment(last), outcome)
        if outcome == text.name:
            return replace(made, ruling=JudgeAnswer.KEPT, reason=reason)
        return replace(made, ruling=JudgeAnswer.BROKEN, reason=reason, tick=last)


@dataclass
class ReadyCase:
    """A property that every mission has. `broken_by`: the first event that breaks it."""

    text: PropertyText
    property: Property
    broken_by: TraceEvent | None = field(default=None)

    def read(self, events: Iterable[TraceEvent]) -> None:
        """Takes in events, in their order."""
        if self.broken_by is None and self.property.seen_as:
            seen_as = self.property.seen_as
            self.broken_by = next((event for event in events if breaks_ready_property(event, seen_as)), None)

    def may_be_broken(self, span: RecordedSpan) -> bool:
        """Whether an event, or the end, broke it."""
        return self.broken_by is not None or span.has_end(self.text.within_s)

    def judgement(self, span: RecordedSpan) -> Judgement:
        """What is said of it, of what is recorded so far."""
        one, within_s = self.property, self.text.within_s
        made = span.undecided(self.text.text, words_within(one.sentence, within_s), Sentence(""))
        last, outcome = span.end_within(within_s)
        if one.monitor is not None and (outcome in one.ends_as or not one.ends_as):
            reason = Sentence("a recording does not hold what this is decided by; ask a run")
            return replace(made, reason=reason)
        if one.seen_as:
            event = self.broken_by
            if event is not None and (within_s is None or event.tick < span.limit(within_s)):
                agents = (span.header.agents[event.agent].name,) if event.agent >= 0 else ()
                return replace(made.broken_at(event.tick), agents=agents)
            if span.header.real:
                return replace(made, reason=Sentence("real robots do not tell what they touch and reach"))
            return replace(made, ruling=JudgeAnswer.KEPT, reason=Sentence("kept in all that was recorded"))
        if outcome is None:
            return replace(made, reason=Sentence("the recording ends before the run does"))
        if span.is_early(within_s) and outcome in one.ends_as:
            return replace(made, reason=TIME_UP_EARLY)
        if outcome == "failed" and one.spares_teams and span.header.plan is not None:
            return replace(made, reason=Sentence("the recording does not say whether the team gave up"))
        reason = Sentence("the run ended at {seconds} s with the outcome {outcome}", span.moment(last), outcome)
        if outcome in one.ends_as:
            return replace(made, ruling=JudgeAnswer.BROKEN, reason=reason, tick=last)
        return replace(made, ruling=JudgeAnswer.KEPT, reason=reason)
