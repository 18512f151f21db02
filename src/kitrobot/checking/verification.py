"""Checking a mission: every property under every assumption that there is time for, from the fast to the thorough."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace

from kitrobot.checking.checked_model import abstract_asked, build_checked_model
from kitrobot.checking.run_explanation import describe_story, explain_verdict, place_explanation
from kitrobot.checking.verification_result import Column, Finding, Verification
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.mission.property_forms import AskedProperty
from kitrobot.mission.trial import FailureKind
from kitrobot.sim.simulation import Simulation
from kitrobot.text.sentences import COMMA, Sentence, Series
from kitrobot.verifier.exploration.budget import Budget
from kitrobot.verifier.model.abstraction import Abstraction
from kitrobot.verifier.model.model import Model
from kitrobot.verifier.model.table_builder import USUAL_KINDS
from kitrobot.verifier.model.timing import Timing
from kitrobot.verifier.properties.approximate_verdicts import check_approximately
from kitrobot.verifier.properties.properties import Property
from kitrobot.verifier.properties.verdicts import Verdict, check_properties
from kitrobot.verifier.report.counterexample_text import free_readings
from kitrobot.verifier.report.explanation import MOST_NODES
from kitrobot.verifier.report.replay import ConfirmedRun, confirm, injected_faults
from kitrobot.verifier.report.state_walk import find_places
from kitrobot.verifier.report.storyboard import draw_scenes, find_culprits
from kitrobot.workspace.child_processes import cores as usable_cores
from kitrobot.workspace.mission_run import PreparedRun

MOST_FAILURES = 3
"""Failures in one run at most."""
MEMORY = 2_000_000_000
"""Bytes that the process of a check may take, where nothing else is said: half of them are for states and steps, the
rest for looking through them for what is waited for."""
_SHARE = 0.5
"""Of the time that is left for each assumption that others follow."""

Progress = Callable[[Timing, int, int, int], None]
"""Told now and then the assumption (timing, failures) and how many states there are, and how deep."""

Runs = Callable[[int], Simulation]
"""Gives the run of a seed before its first step; it has a time limit."""


def _never() -> bool:
    return False


class VerificationError(KitRobotError):
    """A check that makes no sense."""


@dataclass(frozen=True)
class VerificationOptions:
    """What is chosen for a check.

    Attributes:
        properties: the names of those to check; none for all.
        timings: the assumptions, from the fast to the thorough.
        failures: up to how many failures there may be.
        kinds: what a failure may be; of `verifier.KINDS`.
        states: at most so many states under each assumption; None for as many as there is time and memory for.
        seconds: at most so long for all of them; None for no limit.
        confirms: whether broken properties are looked for in the simulator.
        stop: asked now and then whether to break off.
        memory: at most so many bytes of the whole process, about; None for no limit.
        draws: whether runs that break a property are wanted as scenes.
        explains: whether it is wanted why they break it.
        asked: properties that are asked besides those of the mission; if there are any, no others are checked unless
            `properties` names them.
        clock: what tells the time, in seconds.
        cores: at most so many cores explore a large mission beside each other; None for all that there are.
        approximate: whether states are forgotten, so that more can be looked at and nothing be said to hold (see
            `verifier.exploration.approximate_search`).
    """

    properties: tuple[str, ...] = ()
    timings: tuple[Timing, ...] = tuple(Timing)
    failures: int = 0
    kinds: tuple[FailureKind, ...] = USUAL_KINDS
    states: int | None = None
    seconds: float | None = 60.0
    confirms: bool = True
    stop: Callable[[], bool] = _never
    memory: int | None = MEMORY
    draws: bool = False
    explains: bool = False
    asked: tuple[AskedProperty, ...] = ()
    clock: Callable[[], float] = time.monotonic
    cores: int | None = None
    approximate: bool = False


def verify(
    prepared: PreparedRun,
    options: VerificationOptions,
    progress: Progress | None = None,
    column_done: Callable[[Column], None] | None = None,
) -> Verification:
    """Checks a mission; it needs a time limit, within which the simulator confirms what the model finds.

    Raises:
        VerificationError: there is no such property, or a number makes no sense.
        PropertyError: a check cannot decide one of the properties that are asked besides.
        AbstractionError: the mission cannot be checked.
    """
    return verify_runs(prepared.spec.simulation, prepared.options.seed, options, progress, column_done)


def verify_runs(
    runs: Runs,
    seed: int,
    options: VerificationOptions,
    progress: Progress | None = None,
    column_done: Callable[[Column], None] | None = None,
) -> Verification:
    """As `verify`, of a mission given by its runs; the model is made of the one with that seed.

    `column_done` is told every column when it has been explored, and where something is broken once more when the
    simulator was looked through.
    """
    require_failures(options.failures)
    cores = _usable(options.cores)
    run = runs(seed)
    names = (*options.properties, *(one.name for one in options.asked))
    parts = abstract_asked(run, options.asked)
    limits = list(parts.limits)
    ends = None if options.seconds is None else options.clock() + options.seconds
    columns: list[Column] = []
    search = _Search(runs, options, ends)
    assumptions = list(_assumptions(options))
    for failures, timing in assumptions:
        model, properties, left_out = build_checked_model(run, parts, failures, timing, options.kinds, options.asked)
        limits += [words for words in left_out if words not in limits]
        properties = _chosen(properties, names)
        if columns and (options.stop() or (ends is not None and options.clock() > ends)):
            break
        limits += [words for words in _failure_limits(parts, options, failures, properties) if words not in limits]
        left = None if ends is None else max(0.0, ends - options.clock())
        if left is not None and (failures, timing) != assumptions[-1]:
            left *= _SHARE

        def report_progress(states: int, depth: int, timing: Timing = timing, failures: int = failures) -> None:
            if progress is not None:
                progress(timing, failures, states, depth)

        budget = Budget(options.states, left, options.memory, options.stop, report_progress, options.clock, cores)
        judged = (check_approximately if options.approximate else check_properties)(model, properties, budget)
        column = Column(judged, tuple(_finding(verdict, model, options) for verdict in judged.verdicts))
        if column_done is not None:
            column_done(column)
        if not all(finding.searched for finding in column.findings):
            column = Column(
                judged, tuple(search.of(column.findings, model, judged.states if judged.complete else None))
            )
            if column_done is not None:
                column_done(column)
        columns.append(column)
    return Verification(run.tick_ms, tuple(limits), tuple(columns), options.kinds)


def require_failures(count: int) -> None:
    """Refuses a number of failures in one run that a check does not take.

    Raises:
        VerificationError: it is not 0 to `MOST_FAILURES`.
    """
    if not 0 <= count <= MOST_FAILURES:
        raise VerificationError(Sentence("a check takes 0 to {most} failures", MOST_FAILURES))


def _usable(cores: int | None) -> int:
    """How many cores are to explore."""
    there_are = usable_cores()
    if cores is None:
        return there_are
    if not 1 <= cores <= there_are:
        raise VerificationError(
            Sentence.counted(
                "a check takes {count} core on this machine",
                "a check takes 1 to {count} cores on this machine",
                there_are,
            )
        )
    return cores


def _failure_limits(
    parts: Abstraction, options: VerificationOptions, failures: int, properties: Sequence[Property]
) -> Iterator[Sentence]:
    """What is taken for granted of robots that fail."""
    if failures and FailureKind.FAIL in options.kinds and any(one.name == "stock" for one in properties):
        yield Sentence("a box or a unit of work that a robot holds when it fails is taken to be held by it, not lost")
    if failures and FailureKind.MUTE in options.kinds:
        yield _radio_limit(parts)


def _radio_limit(parts: Abstraction) -> Sentence:
    """What is taken for granted of robots that lose their radio."""
    if any(part.shared or part.is_member for part in parts.parts):
        return Sentence("a robot that loses its radio is taken never to have it again")
    return Sentence("nobody loses its radio: no robot of this mission shares a variable")


def _assumptions(options: VerificationOptions) -> Iterator[tuple[int, Timing]]:
    for failures in range(options.failures + 1):
        for timing in options.timings:
            yield failures, timing


def _chosen(properties: list[Property], names: Sequence[str]) -> list[Property]:
    """Those of these names; `served` is all whose name begins so."""
    if not names:
        return properties
    known = [one.name for one in properties]
    for name in names:
        if not any(one == name or one.startswith(f"{name}-") for one in known):
            raise VerificationError(
                Sentence("this mission has no property {name}", name),
                Sentence("its properties are: {names}", Series(COMMA, known)),
            )
    return [one for one in properties if any(one.name == name or one.name.startswith(f"{name}-") for name in names)]


def _finding(verdict: Verdict, model: Model, options: VerificationOptions) -> Finding:
    """A verdict with its run in words."""
    if verdict.counterexample is None:
        return Finding(verdict)
    return _describe_finding(Finding(verdict, searched=not (options.confirms or options.explains)), model, options)


def _describe_finding(finding: Finding, model: Model, options: VerificationOptions) -> Finding:
    """A finding of something broken with its run in words, and in pictures where they are wanted."""
    verdict = finding.verdict
    assert verdict.counterexample is not None, "it is broken"
    decided = -1 if finding.why is None else finding.why.step
    made = replace(finding, story=describe_story(model, verdict.counterexample, decided))
    if not options.draws:
        return made
    return replace(made, scenes=draw_scenes(model, verdict.counterexample), guilty=find_culprits(model, verdict))


class _Search:
    """Looks for why something is broken, and in the simulator for what is, once for what is broken alike; of the time
    that is left it takes a quarter for each column, and half of that for why.
    """

    def __init__(self, runs: Runs, options: VerificationOptions, ends: float | None) -> None:
        self._runs = runs
        self._options = options
        self._ends = ends
        self._known: dict[object, ConfirmedRun | None] = {}

    def of(self, findings: Sequence[Finding], model: Model, states: int | None) -> Iterator[Finding]:
        """The findings of a column, looked for; `states`: how many there are, None where that is not known."""
        now = self._options.clock()
        left = None if self._ends is None else max(0.0, self._ends - now) / 4
        until = None if left is None else now + left
        broken = sum(not finding.searched for finding in findings)
        each = None if left is None else left / 2 / max(1, broken)
        for finding in findings:
            if finding.searched:
                yield finding
                continue
            found = self._look_into(finding, model, states, each, until)
            run = found.verdict.counterexample
            yield replace(found, places=find_places(model, run)) if self._options.draws and run is not None else found

    def _look_into(
        self, finding: Finding, model: Model, states: int | None, seconds: float | None, until: float | None
    ) -> Finding:
        options = self._options

        def stop() -> bool:
            return options.stop() or (until is not None and options.clock() > until)

        explained = None
        if options.explains:
            budget = Budget(MOST_NODES, seconds, stop=options.stop, clock=options.clock)
            explained = explain_verdict(model, finding.verdict, states, budget, options.draws)
        if explained is None:
            return self._confirm(finding, model, stop) if options.confirms else replace(finding, searched=True)
        verdict, found, why = explained
        made = _describe_finding(replace(finding, verdict=verdict, why=why), model, options)
        if not options.confirms:
            return replace(made, searched=True)
        made = self._confirm(made, model, stop)
        if made.confirmed is not None:
            why = place_explanation(model, found, verdict, why, made.confirmed, self._runs, stop)
            return replace(made, why=why)
        whole = self._confirm(finding, model, stop) if found.has_fewer_failures else made
        # A run that was seen is worth more than a smaller one that was not.
        return made if whole.confirmed is None else whole

    def _confirm(self, finding: Finding, model: Model, stop: Callable[[], bool]) -> Finding:
        verdict = finding.verdict
        assert verdict.counterexample is not None, "it is broken"
        key = verdict.property.name, injected_faults(verdict.counterexample, model)
        if key not in self._known:
            confirmed = confirm(verdict.property, verdict.counterexample, model, self._runs, stop)
            if confirmed is None and stop():
                return finding
            self._known[key] = confirmed
        confirmed = self._known[key]
        needs = free_readings(model, verdict.counterexample) if confirmed is None else None
        story = finding.story if needs is None else (*finding.story, (len(verdict.counterexample.steps), needs))
        return replace(finding, confirmed=confirmed, searched=True, story=story)
