"""What a check says of the goals of an exercise: exactly, and where that is cut, approximately for some more states.

The work is bounded by states. An exact search that is cut before it is done says nothing of what it did not find; the
approximate one behind it looks at more states with less memory. What it finds broken is broken. That it finds nothing
is no proof: the goal says whether it is enough.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from typing import Final, Literal, NamedTuple

from kitrobot.checking.checked_model import abstract_asked
from kitrobot.checking.verification import VerificationError, VerificationOptions, verify
from kitrobot.checking.verification_result import Finding, Verification
from kitrobot.diagnostics.problems import ProblemsError
from kitrobot.exercise.evidence import CheckEvidence
from kitrobot.exercise.goals import CheckGoal
from kitrobot.mission.model import Team
from kitrobot.mission.property_forms import AskedProperty
from kitrobot.sim.simulation import Simulation
from kitrobot.text.sentences import Sentence
from kitrobot.verifier.model.model import Model
from kitrobot.verifier.model.programs import AbstractionError
from kitrobot.verifier.model.timing import Timing
from kitrobot.verifier.properties.approximate_verdicts import is_judged_approximately
from kitrobot.verifier.properties.conditions import PropertyError
from kitrobot.verifier.properties.custom_properties import build_custom_property, build_run_property, parse_conditions
from kitrobot.verifier.properties.properties import Property
from kitrobot.verifier.properties.run_conditions import declared_of, team_of
from kitrobot.verifier.properties.verdicts import Answer
from kitrobot.workspace.mission_loader import OpenMission
from kitrobot.workspace.mission_run import PreparedRun, RunOptions

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


class GoalJudges(NamedTuple):
    """Who judges the properties of goals: a check; runs, each with what a run is watched for; or nobody, and why."""

    checks: list[CheckGoal]
    runs: list[tuple[CheckGoal, Property]]
    nobody: list[tuple[CheckGoal, CheckEvidence]]


def assign_judges(prepared: PreparedRun, goals: Iterable[CheckGoal], start: OpenMission | None) -> GoalJudges:
    """Sorts goals by who judges them.

    Runs judge a property that counts seconds, and one that no check can decide: neither of what was handed in nor of
    the mission of the exercise, so that no program gets rid of a proof. What is asked with failures only a check knows.

    Args:
        prepared: what was handed in, in the mission of its exercise.
        goals: the goals.
        start: the mission of the exercise; its roles and groups are those that properties mean.
    """
    made = GoalJudges([], [], [])
    for goal in goals:
        if goal.asked is None:
            made.checks.append(goal)
            continue
        run, asked = prepared.simulation, goal.asked
        try:
            found = build_run_property(asked, run)
            if start is not None:
                _expect_declared(asked, run, start.mission.team)
        except PropertyError as error:
            made.nobody.append((goal, CheckEvidence("none", error.message)))
            continue
        if asked.counts_seconds or (goal.failures == 0 and not _has_check(asked, run, prepared.options, start)):
            made.runs.append((goal, found))
        else:
            made.checks.append(goal)
    return made


def _has_check(asked: AskedProperty, run: Simulation, options: RunOptions, start: OpenMission | None) -> bool:
    """Whether a check can decide a property of the mission of a run, or else of the one that it began as."""
    try:
        build_custom_property(Model(run, abstract_asked(run, (asked,)), 0, Timing.LOCKSTEP), asked)
    except (PropertyError, AbstractionError):
        try:
            return start is not None and _has_check(asked, start.prepare(options).simulation, options, None)
        except ProblemsError:
            return False
    return True


def _expect_declared(asked: AskedProperty, run: Simulation, given: Team) -> None:
    """Refuses a property about a role or a group that a submission declares in another way than its exercise."""
    conditions = parse_conditions(asked, team_of(run), declared_of(run))
    for name in sorted({name for one in conditions for name in one.sets}):
        if _declaration(name, run.mission.team) != _declaration(name, given):
            raise PropertyError(Sentence("`{name}` is declared otherwise than in the mission of the exercise", name))


def _declaration(name: str, team: Team) -> dict[str, object]:
    """What a role or a group is declared as, with the groups inside it."""
    found: dict[str, object] = {}
    waiting = [name]
    while waiting:
        one = waiting.pop()
        if one in found:
            continue
        groups = [group for group in team.groups if group.name == one]
        roles = [(role.robot, role.least, role.most) for role in team.roles if role.name == one]
        found[one] = roles, [(group.members.names, group.failure) for group in groups]
        waiting += [inner for group in groups for inner in group.members.names]
    return found


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
    own = {goal.property: replace(goal.asked, name=goal.property) for goal in goals if goal.asked is not None}
    options = VerificationOptions(
        properties=tuple(name for name in wanted if name not in own),
        timings=(Timing(like.timing),),
        failures=like.failures,
        states=like.states,
        seconds=None,
        stop=stop,
        asked=tuple(own.values()),
    )
    try:
        made = verify(prepared, options)
    except (VerificationError, PropertyError) as error:
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
        asked = tuple(one for one in options.asked if one.name in names)
        ready = tuple(name for name in names if name not in {one.name for one in asked})
        further_options = replace(
            options, properties=ready, asked=asked, states=FURTHER * options.states, approximate=True
        )
        found = verify(prepared, further_options)
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
