"""The plan of a study: the mission with all that it brings along, what varies, which seeds, what is measured.

A plan decides its rows: number n is point n // seeds with seed n % seeds, so all points have the same seeds and are
compared run by run. The id of a row is the hash of what decides its run. It is kept as `plan.toml`, which needs no
other file, on any machine.
"""

from __future__ import annotations

import hashlib
import tomllib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any

import kitrobot
from kitrobot.diagnostics.problems import ProblemsError
from kitrobot.experiments.addresses import PROGRAM, ExperimentError
from kitrobot.experiments.axes import AxisGroup, count_points, point_at, read_axes, read_table
from kitrobot.experiments.measures import USUAL, Measure, make_meter, read_measures
from kitrobot.experiments.mission_addresses import mission_addresses
from kitrobot.experiments.seeds import Seeds, read_seeds
from kitrobot.experiments.toml_text import Plain, write_toml
from kitrobot.experiments.variant import Value
from kitrobot.files.disk import read_text
from kitrobot.mission.model import DEFAULT_RUN_S
from kitrobot.mission.writer import write_mission
from kitrobot.sim.setup.limits import check_limits
from kitrobot.text.json_text import to_json
from kitrobot.text.sentences import Sentence
from kitrobot.trace.model import TracePart
from kitrobot.workspace.mission_loader import OpenMission
from kitrobot.workspace.mission_run import RunOptions
from kitrobot.workspace.traces import parts_of

FORMAT = 1
PLAN_FILE = "plan.toml"
MOST_ROWS = 100_000_000

Function = Callable[[Any], Any]
"""A measure in Python: given the recording of a run (`workspace.traces.OpenTrace`), it gives a number or None."""


@dataclass(frozen=True)
class StudyRequest:
    """What is asked of a study, as text.

    Attributes:
        vary: addresses with their values (see `axes`).
        table: a CSV file of points, by its name; None: none.
        is_zip: whether axes are taken side by side.
        seeds: the seeds (see `seeds`).
        seconds: simulated seconds after which a run is out of time.
        fail_rate: the probability (0…1) that an agent fails for good within a minute.
        measures: what is measured (see `measures`); none: the usual.
        functions: measures in Python, by name.
    """

    vary: Sequence[tuple[str, str]] = ()
    table: Path | None = None
    is_zip: bool = False
    seeds: str = "1"
    seconds: float = DEFAULT_RUN_S
    fail_rate: float = 0.0
    measures: Sequence[str] = ()
    functions: Mapping[str, Function] | None = None


@dataclass(frozen=True)
class Plan:
    """A study before its first run. `parts` are XML files and `files` LLL that the mission needs, each by its name;
    `functions` names measures that are Python.
    """

    name: str
    mission: str
    parts: tuple[TracePart, ...]
    files: tuple[TracePart, ...]
    axes: tuple[AxisGroup, ...]
    is_zip: bool
    seeds: Seeds
    seconds: float
    fail_rate: float
    measures: tuple[Measure, ...]
    functions: tuple[str, ...] = ()
    version: str = kitrobot.__version__

    @cached_property
    def points(self) -> int:
        """How many points there are."""
        return count_points(self.axes, self.is_zip)

    @cached_property
    def rows(self) -> int:
        """How many runs there are."""
        return self.points * len(self.seeds)

    @property
    def addresses(self) -> tuple[str, ...]:
        """What varies."""
        return tuple(name for group in self.axes for name in group.addresses)

    @property
    def measured(self) -> tuple[str, ...]:
        """The names of what is measured."""
        return (*(measure.name for measure in self.measures), *self.functions)

    def point(self, row: int) -> dict[str, Value]:
        """The values of a row, by address."""
        return dict(self._point(row // len(self.seeds))[1])

    def seed(self, row: int) -> int:
        """The seed of a row."""
        return self.seeds[row % len(self.seeds)]

    @cached_property
    def digest(self) -> str:
        """The hash of what all runs have in common."""
        said = [self.version, self.mission, self.seconds, self.fail_rate]
        said += [[part.file, part.text] for part in (*self.parts, *self.files)]
        return hashlib.sha256(to_json(said)).hexdigest()

    def row_id(self, row: int) -> str:
        """24 hexadecimal digits that runs have in common exactly when the same decides them."""
        _, _, begun = self._point(row // len(self.seeds))
        return hashlib.sha256(b"%b,%d]" % (begun, self.seed(row))).hexdigest()[:24]

    def _point(self, number: int) -> tuple[int, dict[str, Value], bytes]:
        """A point: its number, its values, and how the JSON of what decides its rows, [digest, values, seed], begins.

        Rows of one point mostly come one after another, so the last one is kept.
        """
        found: tuple[int, dict[str, Value], bytes] | None = self.__dict__.get("_last_point")
        if found is None or found[0] != number:
            point = point_at(self.axes, self.is_zip, number)
            found = number, point, to_json([self.digest, sorted(point.items())])[:-1]
            self.__dict__["_last_point"] = found
        return found

    def to_toml(self) -> str:
        """As it is kept."""
        head: dict[str, Plain] = {"format": FORMAT, "kitrobot": self.version, "name": self.name}
        head |= {"seeds": self.seeds.text, "seconds": float(self.seconds), "fail_rate": float(self.fail_rate)}
        head |= {"zip": self.is_zip, "functions": list(self.functions)}
        tables: list[tuple[str, Mapping[str, Plain]]] = [
            ("measures", {"name": one.name, "text": one.text}) for one in self.measures
        ]
        tables += [
            ("axes", {"addresses": list(group.addresses), "rows": [list(row) for row in group.rows]})
            for group in self.axes
        ]
        tables.append(("mission", {"text": self.mission}))
        for word, files in (("parts", self.parts), ("files", self.files)):
            tables += [(word, {"file": part.file, "text": part.text}) for part in files]
        return write_toml(head, tables)


def plan_study(opened: OpenMission, request: StudyRequest) -> Plan:
    """The plan of a study of a mission.

    Raises:
        ProblemsError: the mission has errors.
        ExperimentError: something of the request makes no sense.
        SimulationError: seconds or fail rate are none that a run can have.
        FileError: a file cannot be read.
    """
    check_limits(request.seconds, 0, request.fail_rate)
    simulation = opened.prepare(RunOptions(seconds=request.seconds)).simulation
    measures = read_measures(request.measures or ([] if request.functions else USUAL))
    for measure in measures:
        make_meter(measure, simulation)
    known = mission_addresses(opened)
    seeds = read_seeds(request.seeds)
    assert opened.world is not None, "it has no errors"
    mission = write_mission(replace(opened.mission, own_world=opened.world, world_href="")).decode()
    chance = hashlib.sha256(mission.encode()).hexdigest()
    axes = read_axes(request.vary, known, chance)
    if request.table is not None:
        axes.append(read_table(read_text(request.table), request.table.name, known))
        names = [name for group in axes for name in group.addresses]
        twice = next((name for name in names if names.count(name) > 1), None)
        if twice is not None:
            raise ExperimentError(Sentence("`{address}` varies twice", twice))
    made = Plan(
        Path(opened.name).stem,
        mission,
        parts_of(opened),
        tuple(_files(axes)),
        tuple(axes),
        request.is_zip,
        seeds,
        request.seconds,
        request.fail_rate,
        tuple(measures),
        tuple(request.functions or ()),
    )
    if made.rows > MOST_ROWS:
        raise ExperimentError(
            Sentence("this study has {count} runs; at most {most} are run", made.rows, MOST_ROWS),
            Sentence("choose fewer values or seeds"),
        )
    return made


def _files(axes: Sequence[AxisGroup]) -> list[TracePart]:
    """The programs that stand in files, each with its text."""
    found: dict[str, TracePart] = {}
    for group in axes:
        for at, address in enumerate(group.addresses):
            if address.startswith(PROGRAM):
                for name in dict.fromkeys(str(row[at]) for row in group.rows):
                    found.setdefault(name, TracePart(name, read_text(Path(name))))
    return list(found.values())


def read_plan(text: str, name: str) -> Plan:
    """A plan as `to_toml` wrote it; `name` is its file in messages.

    Raises:
        ExperimentError: it is none, or of a later format.
    """
    try:
        found = tomllib.loads(text)
        if found["format"] > FORMAT:
            message = Sentence("`{file}` is of a later version of KitRobot ({version})", name, str(found["kitrobot"]))
            raise ExperimentError(message, Sentence("install that version"))
        return Plan(
            str(found["name"]),
            str(found["mission"][0]["text"]),
            tuple(TracePart(one["file"], one["text"]) for one in found.get("parts", ())),
            tuple(TracePart(one["file"], one["text"]) for one in found.get("files", ())),
            tuple(
                AxisGroup(tuple(one["addresses"]), tuple(tuple(row) for row in one["rows"]))
                for one in found.get("axes", ())
            ),
            bool(found["zip"]),
            read_seeds(found["seeds"]),
            float(found["seconds"]),
            float(found["fail_rate"]),
            tuple(Measure(one["name"], one["text"]) for one in found.get("measures", ())),
            tuple(found["functions"]),
            str(found["kitrobot"]),
        )
    except (KeyError, IndexError, TypeError, ValueError, AttributeError) as error:
        message = Sentence("`{file}` is no plan of a study", name)
        raise ExperimentError(message, Sentence("begin the study anew in another folder")) from error


def first_problem(error: ProblemsError) -> str:
    """Of the mistakes of a mission the first one, as a sentence."""
    wrong = next((item for item in error.diagnostics if item.is_error), None)
    return wrong.message if wrong is not None else error.message
