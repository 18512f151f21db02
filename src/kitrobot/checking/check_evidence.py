"""What a check says of the goals of an exercise: exactly, and where that is cut, approximately for some more states.

The work is bounded by states. An exact search that is cut before it is done says nothing of what it did not find; the
approximate one behind it looks at more states with less memory. What it finds broken is broken. That it finds nothing
is no proof: the goal says whether it is enough.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from typing import Final, Literal

from kitrobot.checking.verification import VerificationError, VerificationOptions, verify
from kitrobot.checking.verification_result import Finding, Verification
from kitrobot.exercise.evidence import CheckEvidence
from kitrobot.exercise.goals import CheckGoal
from kitrobot.text.sentences import Sentence
from kitrobot.verifier.model.programs import AbstractionError
from kitrobot.verifier.model.timing import Timing
from kitrobot.verifier.properties.approximate_verdicts import is_judged_approximately
from kitrobot.verifier.properties.verdicts import Answer
from kitrobot.workspace.mission_run import PreparedRun

STEPS_SHOWN: Final = 4
"""How many of the last steps are shown of a model run that breaks a property."""
FURTHER: Final = 4
"""The approximate search looks at so many times the states at which the exact one was cut."""

_ANSWERS: Final[dict[Answer, Literal["holds", "broken", "not finished", "nothing found", "vacuous"]]] = {
    Answer.BROKEN: "broken",
    Answer.NOT_FINISHED: "not finished",
    Answer.NOT_DECIDED: "not finished",
    Answer.NOTHING_FOUND: "nothing found",
    Answer.VACUOUS: "vacuous",
    Answer.HOLDS: "holds",
}
"""From the worst to the best."""


def _never() -> bool:
    return False


def group_alike(checks: Iterable[CheckGoal]) -> list[list[CheckGoal]]:
    """The goals that one search decides together."""
    found: dict[tuple[str, int, int], list[CheckGoal]] = {}
    for check in checks:
        found.setdefault((check.timing, check.failures, check.states), []).append(check)
    return list(found.values())


def collect_check_evidence(
    prepared: PreparedRun, goals: Sequence[CheckGoal], stop: Callable[[], bool] = _never
) -> dict[str, CheckEvidence]:
    """Checks the properties of goals that are alike, bounded by their states.

    Of each property the worst answer counts: of all numbers of failures, and of all agents that it is about.
    """
    like = goals[0]
    wanted = tuple(dict.fromkeys(goal.property for goal in goals))
    options = VerificationOptions(
        wanted, (Timing(like.timing),), like.failures, states=like.states, seconds=None, stop=stop
    )
    try:
        made = verify(prepared, options)
    except VerificationError as error:
        if len(wanted) == 1:
            return {wanted[0]: CheckEvidence("none", error.message)}
        # One of them does not fit this mission: each by itself.
        return {goal.property: collect_check_evidence(prepared, [goal], stop)[goal.property] for goal in goals}
    except AbstractionError as error:
        return dict.fromkeys(wanted, CheckEvidence("none", error.message))
    findings = _search_further(prepared, options, made)
    seen = {}
    for name in wanted:
        its = [one for one in findings if _is_of(one[0].verdict.property.name, name)]
        if its:
            finding, states = min(its, key=lambda one: list(_ANSWERS).index(one[0].verdict.answer))
            seen[name] = _check_evidence(finding, states, made.tick_ms)
        else:
            seen[name] = CheckEvidence("none", Sentence("nothing was checked"))
    return seen


def _is_of(found: str, name: str) -> bool:
    """Whether a property has that name, or is one of several that agents have, each its own."""
    return found == name or found.startswith(f"{name}-")


def _search_further(
    prepared: PreparedRun, options: VerificationOptions, made: Verification
) -> list[tuple[Finding, int]]:
    """The findings of a check, each with how many states were looked at; those that it did not finish are looked for
    approximately where that can be.
    """
    exact = [(finding, column.judged) for column in made.columns for finding in column.findings]
    left = [
        finding.verdict.property.name
        for finding, _ in exact
        if finding.verdict.answer is Answer.NOT_FINISHED and is_judged_approximately(finding.verdict.property)
    ]
    further: dict[tuple[int, str], tuple[Finding, int]] = {}
    if left and options.states is not None and not options.stop():
        names = tuple(dict.fromkeys(left))
        found = verify(prepared, replace(options, properties=names, states=FURTHER * options.states, approximate=True))
        further = {
            (column.judged.failures, finding.verdict.property.name): (finding, column.judged.states)
            for column in found.columns
            for finding in column.findings
        }
    return [
        further.get((judged.failures, finding.verdict.property.name), (finding, judged.states))
        if finding.verdict.answer is Answer.NOT_FINISHED
        else (finding, judged.states)
        for finding, judged in exact
    ]


def _check_evidence(finding: Finding, states: int, tick_ms: int) -> CheckEvidence:
    verdict, confirmed = finding.verdict, finding.confirmed
    steps = tuple(dict.fromkeys(text for _, text in finding.story[-STEPS_SHOWN:]))
    seed = seconds = None
    if confirmed is not None and not confirmed.faults:
        seed, seconds = confirmed.seed, confirmed.tick * tick_ms / 1000
    return CheckEvidence(_ANSWERS[verdict.answer], verdict.property.sentence, seed, seconds, steps, states)
