"""A run of a mission in the simulator, and its result."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path
from typing import Any, Literal

from kitrobot.diagnostics.model import Diagnostic, Source
from kitrobot.diagnostics.problems import ProblemsError
from kitrobot.diagnostics.read_files import expect_output
from kitrobot.mission.model import DEFAULT_SEED
from kitrobot.primitives.catalogue import Catalogue
from kitrobot.primitives.kit import Kit, as_measured
from kitrobot.sim.event_text import Event
from kitrobot.sim.recorder import simulate, strokes_now
from kitrobot.sim.run_spec import RunSpec
from kitrobot.sim.setup.limits import SimulationError, check_limits
from kitrobot.sim.simulation import Simulation
from kitrobot.sim.step.pens import pens_of
from kitrobot.text.sentences import Sentence
from kitrobot.trace.drawing import Drawing, Stroke
from kitrobot.workspace.mission_loader import OpenMission
from kitrobot.workspace.notebook_html import WorldMoment, moment_of, table_html, world_html
from kitrobot.workspace.run_hints import advice
from kitrobot.workspace.traces import parts_of

Progress = Callable[[float], None]
"""Told the simulated seconds so far, now and then."""


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
        strokes: what pens drew.
        last: the world with its robots as they were at the end.
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
    strokes: tuple[Stroke, ...] = field(default=(), repr=False)
    last: WorldMoment | None = field(default=None, repr=False, compare=False)

    def _repr_html_(self) -> str:
        """The run in a notebook: the world as it was at the end, and what came of it."""
        delivered = sum(self.delivered.values())
        rows = (
            ("outcome", self.outcome),
            ("simulated", f"{self.seconds:.2f} s, {self.ticks} ticks"),
            ("delivered", f"{delivered} of {self.total}" if self.total else ""),
            ("contacts", str(self.collisions)),
            ("took", f"{self.timing.real_seconds:.3f} s"),
        )
        picture = "" if self.last is None else world_html(self.last, self.strokes)
        return f"<figure>{picture}{table_html(self.sentence, rows)}</figure>"

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


@dataclass(frozen=True)
class RunOptions:
    """What is chosen for a run of a mission.

    Attributes:
        seed: where chance begins, 0 to 2^53; the same seed gives the same run.
        seconds: simulated seconds (0 to 10^9) after which it is out of time; None: never.
        fail_rate: the probability (0…1) that an agent fails for good within a minute, by chance.
        trace: a file to record the run in.
        kit: what the robots are built of; they then move as it was measured.

    Examples:
        >>> import kitrobot
        >>> kitrobot.open_mission("transport").prepare(RunOptions(seed=3, seconds=20)).run().outcome
        'time'
    """

    seed: int = DEFAULT_SEED
    seconds: float | None = None
    fail_rate: float = 0.0
    trace: Path | None = None
    kit: Kit | None = None


@dataclass(frozen=True)
class PreparedRun:
    """A mission set up in its world, before its first step; it has no errors."""

    opened: OpenMission
    options: RunOptions
    simulation: Simulation

    @property
    def problems(self) -> tuple[Diagnostic, ...]:
        """What there is to say about the mission all the same: warnings and hints."""
        return self.opened.before_setup

    @property
    def sources(self) -> tuple[Source, ...]:
        """The texts that the problems point into."""
        return self.opened.all_sources

    def run(self, progress: Progress | None = None, watch: Callable[[], Sequence[Event]] | None = None) -> Run:
        """Runs the mission to its end, once; it needs a time limit. `progress` is told the simulated seconds so far.

        `watch` is called after each step of `simulation`; the events that it gives are recorded.

        What pens drew is in the result.

        Raises:
            TraceError: the trace cannot be written.
        """
        made, trace = self.simulation, self.options.trace
        began = time.perf_counter()
        parts = parts_of(self.opened) if trace is not None else ()
        drawn = Drawing(pens_of(made.members))
        simulate(made, trace, None if progress is None else lambda now: progress(now.seconds), parts, drawn, watch)
        real = time.perf_counter() - began
        assert made.outcome is not None, "a run with a time limit ends"
        return Run(
            made.outcome,
            made.sentence,
            made.tick,
            made.seconds,
            made.delivered,
            made.total,
            made.collisions,
            Timing(real, made.seconds / real if real > 0 else 0.0),
            tuple(advice(self.opened, made)),
            tuple(strokes_now(made, drawn)),
            moment_of(made),
        )

    @property
    def spec(self) -> RunSpec:
        """What this run is made of, compiled already; other processes can be given it."""
        return _spec(self.opened, self.options)

    def again(self) -> Simulation:
        """The same run before its first step, by itself.

        Raises:
            ProblemsError: the mission has errors.
        """
        made = prepare(self.opened, self.options).simulation
        assert made.identity == self.simulation.identity, "the same mission, seed and limits are the same run"
        return made


def prepare(opened: OpenMission, options: RunOptions) -> PreparedRun:
    """Sets a mission up in its world; see `OpenMission.prepare`."""
    trace = options.trace
    if trace is not None:
        expect_output(trace, *opened.files)
    # The report would set the mission up once more.
    if not any(item.is_error for item in opened.before_setup):
        try:
            return PreparedRun(opened, options, _set_up(opened, options))
        except ProblemsError:
            if opened.report.ok:
                raise
    report = opened.report
    raise ProblemsError(
        Sentence("`{mission}` has errors, so it was not run", opened.name), "", report.problems, report.sources
    )


def _set_up(opened: OpenMission, options: RunOptions) -> Simulation:
    check_limits(options.seconds, options.seed, options.fail_rate)
    try:
        return _spec(opened, options).simulation()
    except SimulationError as error:
        raise _refused(opened, error) from None


def _spec(opened: OpenMission, options: RunOptions) -> RunSpec:
    assert opened.world is not None, "a mission without its world has an error"
    return RunSpec(
        opened.mission,
        opened.world,
        opened.images,
        _catalogue(opened, options.kit),
        options.seed,
        options.seconds,
        options.fail_rate,
        opened.plan,
    )


def _catalogue(opened: OpenMission, kit: Kit | None) -> Catalogue:
    """The robots of a mission as they move on that kit."""
    if kit is None or not kit.measured:
        return opened.catalogue
    robots = {name: as_measured(robot, kit) for name, robot in opened.catalogue.robots.items()}
    return replace(opened.catalogue, robots=robots)


def _refused(opened: OpenMission, error: SimulationError) -> ProblemsError:
    found = opened.setup_problems(error)
    return ProblemsError(Sentence("`{mission}` cannot be run", opened.name), "", found, opened.sources)
