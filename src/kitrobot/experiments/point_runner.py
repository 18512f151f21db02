"""Runs the rows of a study, one after another, in one process that stays hot.

The mission is opened once. Its tables are built once for each point; for the next seed they are put back to the
beginning (`Simulation.begin_again`), which gives the run that a new one would be. A run that cannot be made is a row.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from enum import Enum, auto
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from kitrobot.diagnostics.model import KitRobotError
from kitrobot.diagnostics.problems import ProblemsError
from kitrobot.experiments.addresses import PROGRAM, ExperimentError
from kitrobot.experiments.measures import make_meter
from kitrobot.experiments.meters import MeterBank
from kitrobot.experiments.mission_addresses import mission_addresses, put_program
from kitrobot.experiments.plan import Function, Plan, first_problem
from kitrobot.experiments.variant import Value, open_variant, variant_of
from kitrobot.sim.recorder import simulate
from kitrobot.sim.simulation import Simulation
from kitrobot.text.json_text import to_json
from kitrobot.text.sentences import Sentence
from kitrobot.workspace.mission_loader import OpenMission, read_mission_data
from kitrobot.workspace.mission_run import PreparedRun, RunOptions
from kitrobot.workspace.search_path import SearchPath
from kitrobot.workspace.traces import open_trace, parts_of

ERROR, DIED = "error", "died"
"""Outcomes of rows without a run: it could not be made; its process died, again and again."""

STRETCH = 20_000
"""Steps in one call of a run that nobody measures on the way."""
PLAIN_STRETCH = 500
"""The same where the step is not compiled, and takes its time."""

Stop = Callable[[], bool]


def _never() -> bool:
    return False


class RunStoppedError(Exception):
    """A run was broken off: there is no row of it."""


class Pace(Enum):
    """How runs come to the compiled step: never, once it is worth it for this process, or from the first one on."""

    PLAIN = auto()
    AS_IT_COMES = auto()
    COMPILED = auto()


def row_bytes(plan: Plan, row: int, outcome: str, sentence: str, fields: Mapping[str, Any] | None = None) -> bytes:
    """A row of a study as a line of JSON, with its break."""
    made = {"row": row, "id": plan.row_id(row), "seed": plan.seed(row), "point": plan.point(row)}
    return to_json({**made, "outcome": outcome, "sentence": sentence, **(fields or {})}) + b"\n"


def open_planned(plan: Plan) -> OpenMission:
    """The mission of a plan, from nothing but the plan.

    Raises:
        ProblemsError: nothing of it can be used.
    """
    with TemporaryDirectory() as folder:
        for part in plan.parts:
            (Path(folder) / Path(part.file).name).write_text(part.text, encoding="utf-8")
        return read_mission_data(plan.mission.encode(), plan.name, SearchPath(Path(folder)))


class PointRunner:
    """Runs rows of a plan. Those of one point, one after another, are quickest.

    Args:
        plan: the study.
        functions: its measures in Python, by name.
        pace: how its runs come to the compiled step.
        stop: whether to break off, asked before and during each run; `run` then raises `RunStoppedError`.
    """

    def __init__(
        self,
        plan: Plan,
        functions: Mapping[str, Function] | None = None,
        pace: Pace = Pace.AS_IT_COMES,
        stop: Stop = _never,
    ) -> None:
        self._plan = plan
        self._stop = stop
        self._functions = functions or {}
        self._pace = pace
        self._opened = open_planned(plan)
        self._addresses = mission_addresses(self._opened)
        self._point = -1
        self._prepared: PreparedRun | None = None
        self._meters: MeterBank
        self._refusal: KitRobotError | None = None

    def run(self, row: int) -> bytes:
        """The row, as a line of JSON."""
        try:
            simulation = self._simulation(row)
            fields = self._fields(simulation, row)
        except KitRobotError as error:
            sentence = first_problem(error) if isinstance(error, ProblemsError) else error.message
            return row_bytes(self._plan, row, ERROR, str(sentence))
        assert simulation.outcome is not None, "it has a time limit"
        return row_bytes(self._plan, row, simulation.outcome, simulation.sentence, fields)

    def prepare(self, row: int) -> PreparedRun:
        """The run of a row before its first step, set up anew.

        Raises:
            KitRobotError: it cannot be made.
        """
        point = self._plan.point(row)
        variant = variant_of(self._opened, self._plan.fail_rate)
        # Programs first: what stands in them is then what addresses of their parts change.
        for name, value in sorted(point.items(), key=lambda item: not item[0].startswith(PROGRAM)):
            self._put(variant, name, value)
        opened = open_variant(variant, self._opened)
        return opened.prepare(RunOptions(self._plan.seed(row), self._plan.seconds, variant.fail_rate))

    def record(self, row: int, file: Path) -> bytes:
        """Records the run of a row, and gives its line as `run` does.

        Raises:
            KitRobotError: it cannot be made or recorded.
        """
        simulation = self._simulation(row)
        self._record(simulation, file)
        fields = self._fields(self._simulation(row), row)
        assert simulation.outcome is not None, "it has a time limit"
        return row_bytes(self._plan, row, simulation.outcome, simulation.sentence, fields)

    def _put(self, variant: Any, name: str, value: Value) -> None:
        address = self._addresses.get(name)
        if address is None:
            raise ExperimentError(Sentence("this mission has no `{address}` that could vary", name))
        if name.startswith(PROGRAM):
            file = next((part for part in self._plan.files if part.file == value), None)
            if file is not None:
                put_program(variant, name.removeprefix(PROGRAM), file.text, self._opened.catalogue, file.file)
            return
        address.put(variant, address.check(value))

    def _simulation(self, row: int) -> Simulation:
        """The run of a row before its first step."""
        point = row // len(self._plan.seeds)
        if point != self._point:
            self._point, self._prepared, self._refusal = point, None, None
            try:
                self._prepared = self.prepare(row)
                run = self._prepared.simulation
                run.stays_plain = self._pace is Pace.PLAIN
                self._meters = MeterBank({one.name: make_meter(one, run) for one in self._plan.measures}, run)
                run.keep_beginning()
                if self._pace is Pace.COMPILED:
                    run.compile_step()
            except KitRobotError as error:
                self._refusal = error
        if self._refusal is not None:
            raise self._refusal
        assert self._prepared is not None, "it was made"
        simulation = self._prepared.simulation
        simulation.begin_again(self._plan.seed(row))
        return simulation

    def _fields(self, simulation: Simulation, row: int) -> dict[str, Any]:
        """Runs to the end; what is measured."""
        self._meters.begin()
        stretch = PLAIN_STRETCH if self._pace is Pace.PLAIN else STRETCH
        while simulation.outcome is None:
            self._look()
            simulation.advance(stretch, tells=False)
            self._meters.after_steps()
        measures = self._meters.values()
        fields = {"seconds": simulation.seconds, "ticks": simulation.tick, "measures": measures}
        outcome, sentence = simulation.outcome, simulation.sentence
        wrong: dict[str, str] = {}
        if self._functions:
            with TemporaryDirectory() as folder:
                file = Path(folder) / "run.krtrace"
                simulation.begin_again(self._plan.seed(row))
                self._record(simulation, file)
                assert (simulation.outcome, simulation.sentence) == (outcome, sentence), "it is the same run"
                for name, function in self._functions.items():
                    measures[name] = _measured(name, function, file, wrong)
        return fields | ({"wrong": wrong} if wrong else {})

    def _look(self) -> None:
        if self._stop():
            raise RunStoppedError

    def _record(self, simulation: Simulation, file: Path) -> None:
        assert self._prepared is not None, "it was set up"
        simulate(simulation, file, None, (*parts_of(self._opened), *self._plan.parts))


def _measured(name: str, function: Function, file: Path, wrong: dict[str, str]) -> Any:
    """What a measure in Python gives; where it gives no number, why."""
    trace = open_trace(file)
    try:
        value = function(trace)
    except Exception as error:
        wrong[name] = f"{type(error).__name__}: {error}"
        return None
    finally:
        trace.reader.close()
    if value is None:
        return None
    try:
        number = float(value)
    except (TypeError, ValueError):
        number = math.nan
    if not math.isfinite(number):
        wrong[name] = str(Sentence("the measure `{name}` gave no number", name))
        return None
    return int(number) if isinstance(value, bool | int) else number
