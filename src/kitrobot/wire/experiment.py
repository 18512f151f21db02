"""Experiments on the wire: what can vary and be measured, studies as they grow, their runs."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, Field, TypeAdapter

from kitrobot.experiments.addresses import Address
from kitrobot.experiments.mission_studies import MissionStudy
from kitrobot.experiments.study_rows import StudyRow, StudyRows
from kitrobot.experiments.summary import Cell, PointSummary, summarise
from kitrobot.experiments.sweep_command import resume_command
from kitrobot.mission.model import DEFAULT_RUN_S
from kitrobot.wire.job import WorkMessage, WorkRefusedMessage
from kitrobot.wire.mission import MissionShape
from kitrobot.wire.sentences import Clause, FileName

MOST_AXES = 6
MOST_MEASURES = 12
LONGEST_TEXT = 400
"""Signs of the values of an axis, of seeds, of a measure."""
LONGEST_S = 36_000.0
"""Simulated seconds that each run may take."""

Text = Annotated[str, Field(min_length=1, max_length=LONGEST_TEXT)]
FoundValue = float | str


class ExperimentAxisShape(BaseModel):
    """An address, and its values as text: a list, a range or a design."""

    address: Text
    values: Text


class ExperimentAskShape(BaseModel):
    """A study that is asked for; `seconds` is the longest simulated time of a run, `fail_rate` (0…1) as in a run."""

    mission: MissionShape
    path: str
    axes: Annotated[list[ExperimentAxisShape], Field(max_length=MOST_AXES)]
    seeds: Text
    measures: Annotated[list[Text], Field(min_length=1, max_length=MOST_MEASURES)]
    seconds: Annotated[float, Field(gt=0, le=LONGEST_S, allow_inf_nan=False)] = DEFAULT_RUN_S
    fail_rate: Annotated[float, Field(ge=0, le=1, allow_inf_nan=False)] = 0.0


class ExperimentMissionShape(BaseModel):
    """A mission whose choices are asked for."""

    mission: MissionShape
    path: str


class AddressShape(BaseModel):
    """What can vary: its address, what stands there ("" for nothing), what can, and some values to begin with."""

    address: str
    current: str
    expected: Clause
    example: str


class StudyEntryShape(BaseModel):
    """A study that lies beside the mission: the name of its folder, and its runs when it is complete."""

    study: FileName
    runs: int


class ExperimentChoicesShape(BaseModel):
    """What a mission has for an experiment: addresses, measures, and the studies of it so far, the newest first."""

    addresses: list[AddressShape]
    measures: list[str]
    studies: list[StudyEntryShape]


class ExperimentPlanShape(BaseModel):
    """What a study would be: how many points and runs, and the command line that does the same."""

    points: int
    runs: int
    command: str


class StudyCellShape(BaseModel):
    """A measure at a point: of how many runs, and its interval where it has one."""

    runs: int
    estimate: float | None
    low: float | None
    high: float | None
    method: Clause


class StudyPointShape(BaseModel):
    """A point: its number, its values by axis, how many runs had which outcome, its cells by measure."""

    number: int
    values: list[FoundValue]
    outcomes: dict[str, int]
    cells: list[StudyCellShape]


class StudyAxisShape(BaseModel):
    """What varies, and all its values in their order, each once."""

    address: str
    values: list[FoundValue]


class StudyShape(BaseModel):
    """A study so far; row number n is point n // `seeds`."""

    study: FileName
    axes: list[StudyAxisShape]
    seeds: int
    measures: list[str]
    seconds: float
    version: str
    done: int
    total: int
    confidence: float
    points: list[StudyPointShape]
    command: str


class StudyRunShape(BaseModel):
    """One run: its number and seed, how it ended, and its measures by place; None: nothing was measured."""

    row: int
    seed: int
    outcome: str
    sentence: str
    measures: list[float | None]


class ExperimentStartRequest(ExperimentAskShape):
    """Make the runs of a study."""

    type: Literal["start"]


class ExperimentResumeRequest(BaseModel):
    """Go on with a study that lies beside the mission of that path."""

    type: Literal["resume"]
    path: str
    study: Text


class ExperimentStopRequest(BaseModel):
    """Break it off; every run that has ended is kept."""

    type: Literal["stop"]


class ExperimentProgressMessage(WorkMessage):
    """How many runs are over, of how many; about how many seconds are left, None while nobody knows; the study so far,
    now and then.
    """

    type: Literal["progress"] = "progress"
    done: int
    total: int
    left_s: float | None
    study: StudyShape | None


class ExperimentStudyMessage(WorkMessage):
    """The study when the work on it ended, complete or broken off."""

    type: Literal["study"] = "study"
    study: StudyShape


ExperimentRequest = Annotated[
    ExperimentStartRequest | ExperimentResumeRequest | ExperimentStopRequest, Field(discriminator="type")
]
EXPERIMENT_REQUEST: TypeAdapter[ExperimentStartRequest | ExperimentResumeRequest | ExperimentStopRequest] = TypeAdapter(
    ExperimentRequest
)
ExperimentMessage = Annotated[
    ExperimentProgressMessage | ExperimentStudyMessage | WorkRefusedMessage, Field(discriminator="type")
]
EXPERIMENT_REQUEST_MODELS: tuple[type[BaseModel], ...] = (
    ExperimentStartRequest,
    ExperimentResumeRequest,
    ExperimentStopRequest,
)
EXPERIMENT_MESSAGE_MODELS: tuple[type[BaseModel], ...] = (ExperimentProgressMessage, ExperimentStudyMessage)


def address_shape(address: Address) -> AddressShape:
    """An address as the page offers it."""
    return AddressShape(
        address=address.name,
        current="" if address.current is None else str(address.current),
        expected=address.expected,
        example=address.example,
    )


def study_entry_shape(study: MissionStudy) -> StudyEntryShape:
    """A study beside a mission, as it is listed."""
    return StudyEntryShape(study=study.name, runs=study.runs)


def study_shape(study: StudyRows) -> StudyShape:
    """A study so far, with its numbers."""
    plan, found = study.plan, summarise(study)
    axes = []
    for group in plan.axes:
        for at, address in enumerate(group.addresses):
            axes.append(StudyAxisShape(address=address, values=list(dict.fromkeys(row[at] for row in group.rows))))
    confidences = [cell.interval.confidence for one in found for cell in one.cells if cell.interval is not None]
    return StudyShape(
        study=study.folder.name,
        axes=axes,
        seeds=len(plan.seeds),
        measures=list(plan.measured),
        seconds=plan.seconds,
        version=plan.version,
        done=sum(sum(one.outcomes.values()) for one in found),
        total=plan.rows,
        confidence=confidences[0] if confidences else 0.95,
        points=[_point_shape(one, plan.addresses) for one in found],
        command=resume_command(study.folder.name),
    )


def _point_shape(point: PointSummary, addresses: tuple[str, ...]) -> StudyPointShape:
    return StudyPointShape(
        number=point.number,
        values=[point.point[address] for address in addresses],
        outcomes=dict(point.outcomes),
        cells=[_cell_shape(cell) for cell in point.cells],
    )


def _cell_shape(cell: Cell) -> StudyCellShape:
    interval = cell.interval
    return StudyCellShape(
        runs=cell.runs,
        estimate=cell.mean if interval is None else interval.estimate,
        low=None if interval is None else interval.low,
        high=None if interval is None else interval.high,
        method="" if interval is None else interval.method,
    )


def study_run_shape(row: StudyRow, measures: tuple[str, ...]) -> StudyRunShape:
    """A run of a study, as a dot of the page."""
    return StudyRunShape(
        row=row.number,
        seed=row.seed,
        outcome=row.outcome,
        sentence=row.sentence,
        measures=[row.measures.get(name) for name in measures],
    )
