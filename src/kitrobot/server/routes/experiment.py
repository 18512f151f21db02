"""The requests behind experiments: what a mission has for them, studies beside it, their runs; `WS /api/experiment`.

Left to others: making a study (`live.study_work`), finding it (`experiments.mission_studies`).
"""

from __future__ import annotations

import io
import shutil
from pathlib import Path
from typing import Annotated, ClassVar

from fastapi import Query
from fastapi.responses import PlainTextResponse

from kitrobot.diagnostics.problems import ProblemsError
from kitrobot.experiments.measures import offered_measures
from kitrobot.experiments.mission_addresses import mission_addresses
from kitrobot.experiments.mission_studies import find_study, studies_of
from kitrobot.experiments.study_rows import StudyRows
from kitrobot.experiments.sweep_command import sweep_command
from kitrobot.experiments.tables import write_csv
from kitrobot.live.studio import Studio
from kitrobot.live.study_work import StudyWork, begin_page_study, plan_page_study, study_request, study_runs
from kitrobot.server.routes.api_router import ThisStudio, api_router
from kitrobot.server.routes.missions import Name
from kitrobot.server.routes.trace import open_recording
from kitrobot.server.routes.websocket_jobs import WebSocketJob
from kitrobot.text.sentences import Sentence
from kitrobot.trace.layout import ENDING
from kitrobot.wire.experiment import (
    EXPERIMENT_REQUEST,
    ExperimentAskShape,
    ExperimentChoicesShape,
    ExperimentMissionShape,
    ExperimentPlanShape,
    ExperimentProgressMessage,
    ExperimentResumeRequest,
    ExperimentStartRequest,
    ExperimentStudyMessage,
    StudyRunShape,
    StudyShape,
    address_shape,
    study_entry_shape,
    study_run_shape,
    study_shape,
)
from kitrobot.wire.mission import mission_from_shape
from kitrobot.wire.recording import RecordingShape
from kitrobot.workspace.mission_run import RunOptions

experiment_routes = api_router()
RowNumber = Annotated[int, Query(ge=0, le=2**53)]


@experiment_routes.post("/experiment/choices")
def choices(studio: ThisStudio, asked: ExperimentMissionShape) -> ExperimentChoicesShape:
    """What can vary and be measured in a mission, and the studies that lie beside it."""
    opened = studio.open(mission_from_shape(asked.mission), asked.path)
    studies = studies_of(studio.folder.own_folder_of(asked.path), Path(opened.name).stem)
    listed = [study_entry_shape(study) for study in studies]
    try:
        simulation = opened.prepare(RunOptions(seconds=1.0)).simulation
    except ProblemsError:
        # What was studied before is there all the same.
        return ExperimentChoicesShape(addresses=[], measures=[], studies=listed)
    return ExperimentChoicesShape(
        addresses=[address_shape(one) for one in mission_addresses(opened).values() if not one.any_word],
        measures=offered_measures(simulation),
        studies=listed,
    )


@experiment_routes.post("/experiment/plan")
def plan(studio: ThisStudio, asked: ExperimentAskShape) -> ExperimentPlanShape:
    """How many runs a study would have, and the command line that makes it; what is wrong with it is refused."""
    opened = studio.open(mission_from_shape(asked.mission), asked.path)
    planned = plan_page_study(opened, asked)
    command = sweep_command(Path(asked.path or opened.name).name, study_request(asked))
    return ExperimentPlanShape(points=planned.points, runs=planned.rows, command=command)


@experiment_routes.get("/experiment/study")
def study(studio: ThisStudio, path: Name, study: Name) -> StudyShape:
    """A study so far."""
    return study_shape(_study(studio, path, study))


@experiment_routes.get("/experiment/runs")
def runs(studio: ThisStudio, path: Name, study: Name, first: RowNumber, count: RowNumber) -> list[StudyRunShape]:
    """The runs of a study that are over, among so many from a number on."""
    found = _study(studio, path, study)
    return [study_run_shape(row, found.plan.measured) for row in study_runs(found, first, count)]


@experiment_routes.get("/experiment/table", response_class=PlainTextResponse)
def table(studio: ThisStudio, path: Name, study: Name) -> PlainTextResponse:
    """The rows of a study as CSV."""
    out = io.StringIO()
    write_csv(_study(studio, path, study), out)
    return PlainTextResponse(out.getvalue(), media_type="text/csv")


@experiment_routes.post("/experiment/replay")
def replay(studio: ThisStudio, path: Name, study: Name, row: RowNumber) -> RecordingShape:
    """The very run of a row, recorded once more and opened."""
    found = _study(studio, path, study)
    wanted = found.row(row)
    file = studio.recordings.new_file(f"{found.folder.name}-{row}{ENDING}")
    try:
        return open_recording(studio, found.record(wanted, file))
    except BaseException:
        shutil.rmtree(file.parent, ignore_errors=True)
        raise


def _study(studio: Studio, path: str, name: str) -> StudyRows:
    return StudyRows(find_study(studio.folder.own_folder_of(path), name))


class _Experiment(WebSocketJob):
    kind = "experiment"
    request: ClassVar = EXPERIMENT_REQUEST
    start = (ExperimentStartRequest, ExperimentResumeRequest)
    progress = ExperimentProgressMessage
    busy = Sentence("this studio is at an experiment already")

    def work(self, request: ExperimentStartRequest | ExperimentResumeRequest) -> ExperimentStudyMessage:
        folder = self.studio.folder.own_folder_of(request.path)
        if isinstance(request, ExperimentResumeRequest):
            place = find_study(folder, request.study)
        else:
            place = begin_page_study(folder, self.open(request), request)
        return ExperimentStudyMessage(study=StudyWork(place, self.send_progress).run(self.stop.is_set))


experiment_routes.routes.extend(_Experiment.routes_at("/api/experiment").routes)
