"""What a judge says of a property: kept, broken or not decided, with the ground for it.

Left to others: how a judge comes to it (mission_judges, record_monitor, recording_judge, run_watch).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum
from typing import Any, TypedDict

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.text.phrases import listed
from kitrobot.text.sentences import Recorded, Sentence


class Judge(StrEnum):
    """Who judges."""

    CHECK = "check"
    RUN = "run"
    RUNS = "runs"
    FAILURES = "failures"
    RECORDING = "recording"
    TEAM = "team"


class JudgeAnswer(StrEnum):
    """What a judge says. Each means what that judge saw: one run, many, or all orders of events."""

    KEPT = "kept"
    BROKEN = "broken"
    NOT_DECIDED = "not decided"


TIME_UP_EARLY = Sentence("the time of the run was up before the deadline")
"""Why a run says nothing of a question about a later moment."""


class JudgeError(KitRobotError):
    """A question to judges that makes no sense."""


class JudgeLimits(TypedDict, total=False):
    """What limits the judges of `judge`."""

    seed: int
    seconds: float
    fail_rate: float
    runs: int
    moments: int
    check_seconds: float
    timings: Sequence[str]
    approximate: bool
    jobs: int | None


@dataclass(frozen=True, slots=True)
class Judgement:
    """What one judge says of one property.

    Attributes:
        judge: who says it.
        subject: the file that it is said of.
        question: the property as it was asked: its name, or its text.
        words: what it demands.
        ruling: what is said.
        reason: the ground: where it broke, in how many runs it was kept, why it is not decided.
        tick: the tick in which it broke; -1 where there is none.
        tick_ms: simulated time of a tick, in ms.
        seed: the seed of the run that breaks it; None where there is none.
        faults: what was done to robots in that run: the tick, the robot's name, and what (`fail`, `stall`, `mute`).
        agents: the robots that the property speaks of.
        why: of a check, why it breaks, in three sentences at most: what happened, what decided it, what would have
            avoided it.
    """

    judge: Judge
    subject: str
    question: str
    words: Sentence
    ruling: JudgeAnswer
    reason: Sentence
    tick: int = -1
    tick_ms: float = 0.0
    seed: int | None = None
    faults: tuple[tuple[int, str, str], ...] = ()
    agents: tuple[str, ...] = ()
    why: tuple[Sentence, ...] = ()

    @property
    def seconds(self) -> float | None:
        """When it broke, in simulated seconds; None where there is no such moment."""
        return round(self.tick * self.tick_ms / 1000, 3) if self.tick >= 0 else None

    def kept_at(self, tick: int) -> Judgement:
        """The same, kept: it was decided in that tick."""
        return replace(self, ruling=JudgeAnswer.KEPT, reason=Sentence("decided at {seconds} s", self._moment(tick)))

    def broken_at(self, tick: int) -> Judgement:
        """The same, broken in that tick."""
        reason = Sentence("broken at {seconds} s (tick {tick})", self._moment(tick), tick)
        return replace(self, ruling=JudgeAnswer.BROKEN, reason=reason, tick=tick)

    @property
    def break_sentence(self) -> Sentence:
        """The break as a line of a log: the property, the moment, the robots that it speaks of."""
        moment = self._moment(self.tick)
        if not self.agents:
            return Sentence("the property `{name}` is broken at {seconds} s", self.question, moment)
        return Sentence(
            "the property `{name}` is broken at {seconds} s; it speaks of {robots}",
            self.question,
            moment,
            listed(self.agents),
        )

    def _moment(self, tick: int) -> str:
        return f"{tick * self.tick_ms / 1000:.2f}"

    def to_json(self) -> dict[str, Any]:
        """As plain values, in the published shape."""
        return {
            "judge": self.judge.value,
            "of": self.subject,
            "property": self.question,
            "sentence": str(self.words),
            "ruling": self.ruling.value,
            "reason": str(self.reason),
            "tick": self.tick if self.tick >= 0 else None,
            "seconds": self.seconds,
            "seed": self.seed,
            "failures": [
                {"seconds": round(tick * self.tick_ms / 1000, 3), "agent": agent, "what": what}
                for tick, agent, what in self.faults
            ],
            "agents": list(self.agents),
            "why": [str(sentence) for sentence in self.why],
        }


def break_text(question: str) -> Recorded:
    """A break as an event of a run; `question`: the property as it was asked."""
    return Recorded("the property {name} is broken", question)


def exit_status(judgements: Iterable[Judgement]) -> int:
    """0 when all is kept, 1 when something is broken, 3 when nothing is and something is not decided."""
    rulings = {one.ruling for one in judgements}
    return 1 if JudgeAnswer.BROKEN in rulings else 3 if JudgeAnswer.NOT_DECIDED in rulings else 0
