"""A check in a process of its own, so that the one that asks goes on; what is found comes as plain values.

Left to others: checking (`verification`), telling people (server).
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from dataclasses import dataclass, fields, replace
from typing import TYPE_CHECKING, Any

from kitrobot.checking.verification import VerificationError, VerificationOptions, verify_runs
from kitrobot.checking.verification_result import Column, Finding, RunReport, Verification
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.sim.run_spec import RunSpec
from kitrobot.text.sentences import Sentence
from kitrobot.verifier.exploration.budget import CutReason
from kitrobot.verifier.model.timing import Timing
from kitrobot.verifier.properties.verdicts import Answer
from kitrobot.workspace.child_processes import end_with_parent, has_processes
from kitrobot.workspace.mission_run import PreparedRun

if TYPE_CHECKING:
    from multiprocessing.connection import Connection

MOST_EVENTS = 600
"""Events of one run that are told; of a longer one the first and the last."""
_LOOK_S = 0.1
"""How long nobody looks whether a check is to be broken off, in seconds."""
_EACH_S = 0.1
"""Seconds between two words of progress."""
_MEMORY_HERE = 600_000_000
"""Bytes that a check may take at most where there are no processes, about: the page itself runs there."""
_PATIENCE_S = 5.0
"""How long a check that is broken off may take to judge what it has; then its process is ended."""


@dataclass(frozen=True)
class ExplorationProgress:
    """How far a check is.

    Attributes:
        timing, failures: the assumption.
        states, depth: how many states there are, and how deep.
        seconds: how long it is at this assumption.
        memory: bytes that its process has taken at most; 0 where the system does not report it.
    """

    timing: Timing
    failures: int
    states: int
    depth: int
    seconds: float
    memory: int


@dataclass(frozen=True)
class PropertyAnswer(RunReport):
    """What came of one property under one assumption.

    Attributes:
        name, sentence: the property.
        answer: the answer.
        steps: of one that is broken, the steps of the run that breaks it.
        repeats_from: the step from which on it repeats; -1: it does not.
        left_out: how many of its events are left out in the middle.
    """

    name: str
    sentence: Sentence
    answer: Answer
    steps: int = 0
    repeats_from: int = -1
    left_out: int = 0


@dataclass(frozen=True)
class CheckedColumn:
    """The results of all properties under one assumption; see `verifier.CheckResult`.

    It may be reported twice: at first the simulator has not been searched for runs that break the properties.
    """

    timing: Timing
    failures: int
    states: int
    depth: int
    cut: CutReason | None
    seconds: float
    properties: tuple[PropertyAnswer, ...]
    is_approximate: bool = False
    odds: float | None = None


@dataclass(frozen=True)
class CheckEnd:
    """The check is over: the length of a step of the simulator, and what is taken for granted, in sentences."""

    tick_ms: int
    limits: tuple[str, ...]


@dataclass(frozen=True)
class _Refusal:
    message: Sentence
    help: Any


ReportProgress = Callable[[ExplorationProgress | CheckedColumn], None]


def verify_apart(prepared: PreparedRun, options: VerificationOptions, report: ReportProgress) -> CheckEnd | None:
    """Checks a mission in another process; None where it was broken off before it could send its end.

    Raises:
        VerificationError: the options make no sense, or the process died.
        AbstractionError: as a `KitRobotError` with the same words: the mission cannot be checked.
    """
    if not has_processes():
        return _verify_here(prepared, options, report)
    import multiprocessing

    context = multiprocessing.get_context("spawn")
    mine, its = context.Pipe(duplex=False)
    leave_off = context.Event()
    chosen = replace(options, stop=VerificationOptions.stop)
    process = context.Process(
        target=_check, args=(prepared.spec, prepared.options.seed, chosen, leave_off, its), daemon=True
    )
    process.start()
    its.close()
    try:
        return _follow(mine, options.stop, leave_off, report)
    except (EOFError, OSError) as error:
        raise VerificationError(
            Sentence("the process of the check died"),
            Sentence("perhaps for want of memory: allow fewer failures, or give it less time"),
        ) from error
    finally:
        mine.close()
        process.kill()
        process.join()


def _follow(mine: Connection, stop: Callable[[], bool], leave_off: Any, report: ReportProgress) -> CheckEnd | None:
    stopped_at: float | None = None
    while True:
        if stopped_at is None and stop():
            stopped_at = time.monotonic()
            leave_off.set()
        if stopped_at is not None and time.monotonic() > stopped_at + _PATIENCE_S:
            return None
        if not mine.poll(_LOOK_S):
            continue
        message = mine.recv()
        if isinstance(message, _Refusal):
            raise KitRobotError(message.message, message.help)
        if isinstance(message, CheckEnd):
            return message
        report(message)


def _check(spec: RunSpec, seed: int, chosen: VerificationOptions, leave_off: Any, out: Connection) -> None:
    """In the process of the check."""
    end_with_parent()
    _whole_check(spec, seed, replace(chosen, stop=leave_off.is_set, draws=True, explains=True), out.send)
    out.close()


def _verify_here(prepared: PreparedRun, options: VerificationOptions, report: ReportProgress) -> CheckEnd:
    """Where there are no processes; whoever wants to break it off says so in `options.stop`."""
    last: list[CheckEnd | _Refusal] = []

    def send(message: Any) -> None:
        if isinstance(message, CheckEnd | _Refusal):
            last.append(message)
        else:
            report(message)

    chosen = replace(options, draws=True, explains=True, memory=_MEMORY_HERE)
    _whole_check(prepared.spec, prepared.options.seed, chosen, send)
    end = last[-1]
    if isinstance(end, _Refusal):
        raise KitRobotError(end.message, end.help)
    return end


def _whole_check(spec: RunSpec, seed: int, options: VerificationOptions, send: Callable[[Any], None]) -> None:
    """Sends the progress, each explored column, and finally a `CheckEnd` or a `_Refusal`."""
    began = time.monotonic()
    assumption: list[tuple[Timing, int]] = []
    last = 0.0

    def progress(timing: Timing, failures: int, states: int, depth: int) -> None:
        nonlocal began, last
        now = time.monotonic()
        if assumption != [(timing, failures)]:
            assumption[:] = [(timing, failures)]
            began = now
        if now >= last + _EACH_S:
            last = now
            send(ExplorationProgress(timing, failures, states, depth, now - began, memory_taken()))

    try:
        made = verify_runs(spec.simulation, seed, options, progress, lambda column: send(_plain(column)))
        send(_end(made))
    except KitRobotError as error:
        send(_Refusal(error.message, error.help))


def _end(made: Verification) -> CheckEnd:
    return CheckEnd(made.tick_ms, made.limits)


def _plain(column: Column) -> CheckedColumn:
    judged = column.judged
    return CheckedColumn(
        judged.timing,
        judged.failures,
        judged.states,
        judged.depth,
        judged.cut,
        judged.seconds,
        tuple(_answered(finding) for finding in column.findings),
        judged.is_approximate,
        judged.odds,
    )


def _answered(finding: Finding) -> PropertyAnswer:
    verdict, run, story = finding.verdict, finding.verdict.counterexample, finding.story
    one = verdict.property
    if run is None:
        return PropertyAnswer(one.name, one.sentence, verdict.answer)
    left_out = max(0, len(story) - MOST_EVENTS)
    if left_out:
        story = (*story[: MOST_EVENTS // 2], *story[left_out + MOST_EVENTS // 2 :])
    shown = {field.name: getattr(finding, field.name) for field in fields(RunReport)} | {"story": story}
    return PropertyAnswer(one.name, one.sentence, verdict.answer, len(run.steps), run.repeats_from, left_out, **shown)


def memory_taken() -> int:
    """The most bytes that this process has taken; 0 where the system does not report it."""
    try:
        import resource
    except ImportError:  # Windows
        return 0
    most = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return most if sys.platform == "darwin" else most * 1024
