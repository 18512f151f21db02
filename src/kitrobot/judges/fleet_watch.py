"""Watches a run that is recorded while it goes on, as that of a fleet; what breaks is an event of the run."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from kitrobot.judges.judgement import Judge, Judgement, break_text
from kitrobot.judges.record_monitor import RecordMonitor
from kitrobot.text.sentences import Sentence
from kitrobot.trace.model import TickRecord, TraceEvent, TraceHeader
from kitrobot.workspace.mission_loader import OpenMission


class FleetWatch:
    """Watches the records of a fleet for properties; it says of each what a recording of that run says afterwards.

    Args:
        header: of the recording.
        opened: the mission that runs.
        questions: properties as text, or their names; none for all of the mission's own.
        on_broken: called at once with what breaks, as a sentence.

    Attributes:
        broken: what broke so far, in order.

    Raises:
        QuestionError: a question cannot be understood, or the mission has no such property.
        PropertyError: a condition cannot be understood, or names something that does not exist.
    """

    def __init__(
        self,
        header: TraceHeader,
        opened: OpenMission,
        questions: Sequence[str],
        on_broken: Callable[[Sentence], None],
    ) -> None:
        self._monitor = RecordMonitor(header, opened, questions, Judge.TEAM, opened.name)
        self._on_broken = on_broken
        self.broken: list[Judgement] = []

    def after_step(self, record: TickRecord, outcome: str | None) -> None:
        """Looks at a record, that before the first step too, and adds what broke to its events; `outcome`: how the run
        ended with it, None where it goes on.
        """
        for one in self._monitor.follow(record, outcome):
            self.broken.append(one)
            record.events.append(TraceEvent(record.tick, "message", -1, break_text(one.question), "program"))
            self._on_broken(one.break_sentence)

    def judgements(self) -> list[Judgement]:
        """What is said of each property so far."""
        return self._monitor.judgements()
