"""A mission run in the simulator, and what came of it."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any, Literal

from kitrobot.diagnostics import Diagnostic, KitRobotError, Place
from kitrobot.sim import Simulation, SimulationError, check_limits, look_over, simulate
from kitrobot.workspace.advising import advice
from kitrobot.workspace.files import same_file
from kitrobot.workspace.opening import OpenMission
from kitrobot.workspace.problems import ProblemsError
from kitrobot.workspace.traces import parts_of

Progress = Callable[[float], None]
"""Told the simulated seconds so far, now and then."""


class TracePlaceError(KitRobotError):
    """The trace would be written over the mission."""


@dataclass(frozen=True)
class Timing:
    """What the clock on the wall decided: how long the run took, and simulated seconds a real second."""

    real_seconds: float
    speed: float


@dataclass(frozen=True)
class Run:
    """What came of a run; everything but `timing` follows from the mission and the seed.

    Attributes:
        outcome: done, failed, stuck (nothing can change any more) or time (the time given ran out).
        sentence: why it ended.
        ticks: steps of the simulator.
        seconds: simulated time.
        delivered: boxes that each carrier brought, by its name.
        total: boxes there are.
        collisions: how many times a robot began to touch something.
        timing: what the clock on the wall decided.
        advice: hints on a run that ended before anything could be seen.
    """

    outcome: Literal["done", "failed", "stuck", "time"]
    sentence: str
    ticks: int
    seconds: float
    delivered: Mapping[str, int]
    total: int
    collisions: int
    timing: Timing
    advice: tuple[Diagnostic, ...] = ()

    def to_json(self) -> dict[str, Any]:
        """As plain values, in the published shape."""
        return {
            "outcome": self.outcome,
            "sentence": self.sentence,
            "ticks": self.ticks,
            "seconds": self.seconds,
            "delivered": dict(self.delivered),
            "total": self.total,
            "collisions": self.collisions,
            "timing": {name: round(value, 3) for name, value in asdict(self.timing).items()},
        }


def simulation(opened: OpenMission, seed: int, seconds: float | None = None, fail_rate: float = 0.0) -> Simulation:
    """A mission in its world, before its first tick; `seconds` is its time limit, `fail_rate` as in `Simulation`.

    Raises:
        ProblemsError: the mission has errors; all are told.
    """
    # The report would let the team take its places once more.
    if not any(item.is_error for item in opened.before_staging):
        try:
            return stage(opened, seed, seconds, fail_rate)
        except ProblemsError:
            if opened.report.ok:
                raise
    report = opened.report
    raise ProblemsError(f"`{opened.name}` has errors, so it was not run", "", report.problems, report.sources)


def once_more(opened: OpenMission, was: Simulation) -> Simulation:
    """The run `was` of a mission before its first step, by itself.

    Raises:
        ProblemsError: the mission has errors.
    """
    made = simulation(opened, was.seed, was.seconds_limit, was.fail_rate)
    assert made.identity == was.identity, "the same mission, seed and limits are the same run"
    return made


def stage(opened: OpenMission, seed: int, seconds: float | None = None, fail_rate: float = 0.0) -> Simulation:
    """As `simulation`, for a mission that was found free of errors otherwise.

    Raises:
        ProblemsError: it does not fit its world.
        SimulationError: a number makes no sense (see `check_limits`).
    """
    assert opened.world is not None, "a mission without its world has an error"
    check_limits(seconds, seed, fail_rate)
    try:
        return Simulation(opened.mission, opened.world, opened.compiled, opened.catalogue, seed, seconds, fail_rate)
    except SimulationError as error:
        raise _refused(opened, error) from None


def look_whether_it_runs(opened: OpenMission) -> None:
    """As `stage`, without making the run.

    Raises:
        ProblemsError: it does not fit its world.
    """
    assert opened.world is not None, "a mission without its world has an error"
    try:
        look_over(opened.mission, opened.world, opened.compiled, opened.catalogue)
    except SimulationError as error:
        raise _refused(opened, error) from None


def _refused(opened: OpenMission, error: SimulationError) -> ProblemsError:
    found = tuple(_placed(opened, item) for item in error.diagnostics)
    return ProblemsError(f"`{opened.name}` cannot be run", "", found, opened.sources)


def run(
    opened: OpenMission,
    seed: int,
    seconds: float,
    trace: Path | None,
    progress: Progress | None,
    fail_rate: float = 0.0,
) -> Run:
    """Runs a mission to its end; see `OpenMission.run`."""
    if trace is not None and opened.path is not None and same_file(trace, opened.path):
        raise TracePlaceError(f"the trace would be written over `{trace}`", "give it a name of its own")
    made = simulation(opened, seed, seconds, fail_rate)
    began = time.perf_counter()
    parts = parts_of(opened) if trace is not None else ()
    simulate(made, trace, None if progress is None else lambda now: progress(now.seconds), parts)
    real = time.perf_counter() - began
    assert made.outcome is not None, "a run with a time limit ends"
    timing = Timing(real, made.seconds / real if real > 0 else 0.0)
    return Run(
        made.outcome,
        made.sentence,
        made.tick,
        made.seconds,
        made.delivered,
        made.total,
        made.collisions,
        timing,
        tuple(advice(opened, made)),
    )


def _placed(opened: OpenMission, item: Diagnostic) -> Diagnostic:
    """What the stage found, with the mission's file as its place where it has none."""
    if item.place is not None or opened.text is None:
        return item
    return opened.placed([item])[0] if item.program else replace(item, place=Place(opened.name))
