"""What came of a check: for each assumption a column of findings, one for each property; as plain values too."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from kitrobot.checking.run_explanation import RunExplanation
from kitrobot.mission.trial import FailureKind
from kitrobot.text.sentences import Sentence
from kitrobot.verifier.exploration.engine_policy import would_gain
from kitrobot.verifier.model.table_builder import USUAL_KINDS
from kitrobot.verifier.properties.verdicts import Answer, CheckResult, Verdict
from kitrobot.verifier.report.replay import ConfirmedRun
from kitrobot.verifier.report.storyboard import Culprit, Scene


@dataclass(frozen=True, kw_only=True)
class RunReport:
    """A run that breaks a property as it is shown, in plain values; empty where nothing is broken.

    Attributes:
        confirmed: the run of the simulator that breaks it too, if one was found.
        story: the events of the model's run in words, each with its step.
        searched: whether the simulator was looked through for such a run, and why it is broken was asked, or need not
            be.
        scenes, guilty: the run as pictures, and where it is broken, where pictures are wanted.
        places: its steps as a walk by hand takes them (`state_walk`), as `scenes`.
        why: why it is broken, where that is wanted.
    """

    confirmed: ConfirmedRun | None = None
    story: tuple[tuple[int, Sentence], ...] = ()
    searched: bool = True
    scenes: tuple[Scene, ...] = ()
    guilty: tuple[Culprit, ...] = ()
    places: tuple[int, ...] = ()
    why: RunExplanation | None = None


@dataclass(frozen=True)
class Finding(RunReport):
    """A verdict, with the run that breaks the property."""

    verdict: Verdict


@dataclass(frozen=True)
class Column:
    """The findings under one assumption."""

    judged: CheckResult
    findings: tuple[Finding, ...]


@dataclass(frozen=True)
class Verification:
    """What came of a check.

    Attributes:
        tick_ms: a step of the simulator.
        limits: what the model takes more generously than the simulator is, in sentences.
        columns: the assumptions that were checked, in order.
        kinds: what a failure may be.
    """

    tick_ms: int
    limits: tuple[str, ...]
    columns: tuple[Column, ...]
    kinds: tuple[FailureKind, ...] = USUAL_KINDS

    @property
    def answers(self) -> list[Answer]:
        """All answers."""
        return [finding.verdict.answer for column in self.columns for finding in column.findings]

    @property
    def would_gain(self) -> bool:
        """Whether it was long, and would have been much quicker if Numba were installed."""
        return would_gain(sum(column.judged.states for column in self.columns))

    def to_json(self) -> dict[str, Any]:
        """As plain values, in the published shape."""
        return {
            "limits": list(self.limits),
            "checks": [
                {
                    "timing": column.judged.timing.value,
                    "failures": column.judged.failures,
                    "kinds": [kind.value for kind in self.kinds] if column.judged.failures else [],
                    "states": column.judged.states,
                    "depth": column.judged.depth,
                    "complete": column.judged.complete,
                    "cut": None if column.judged.cut is None else column.judged.cut.value,
                    "approximate": column.judged.is_approximate,
                    "missed_odds": column.judged.odds,
                    "properties": [_finding_json(finding, self.tick_ms) for finding in column.findings],
                    "timing_seconds": round(column.judged.seconds, 3),
                    "memory_bytes": column.judged.memory,
                }
                for column in self.columns
            ],
        }


def _finding_json(finding: Finding, tick_ms: int) -> dict[str, Any]:
    verdict, confirmed = finding.verdict, finding.confirmed
    made: dict[str, Any] = {
        "name": verdict.property.name,
        "sentence": str(verdict.property.sentence),
        "answer": verdict.answer.value,
    }
    if verdict.counterexample is not None:
        made["run"] = [{"step": step, "text": str(text)} for step, text in finding.story]
        made["steps"] = len(verdict.counterexample.steps)
        made["repeats_from"] = verdict.counterexample.repeats_from if verdict.counterexample.repeats_from >= 0 else None
        made["confirmed"] = None if confirmed is None else confirmed.to_json(tick_ms)
        made["why"] = None if finding.why is None else finding.why.to_json(tick_ms)
    return made
