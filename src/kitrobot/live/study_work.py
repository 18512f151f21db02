"""Studies that a page begins and goes on with: planned, made over the processes of this machine, told as they grow.

They lie beside their mission as folders, so the command line goes on with them, and a page that is loaded again finds
them. Left to others: HTTP; what a study is (`experiments`).
"""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path

from kitrobot.experiments.addresses import PROGRAM, ExperimentError
from kitrobot.experiments.mission_studies import choose_study_folder
from kitrobot.experiments.plan import Plan, StudyRequest, plan_study
from kitrobot.experiments.study import choose_executor
from kitrobot.experiments.study_folder import begin_study
from kitrobot.experiments.study_rows import StudyRow, StudyRows
from kitrobot.experiments.study_run import run_study
from kitrobot.text.sentences import Sentence
from kitrobot.wire.experiment import ExperimentAskShape, ExperimentProgressMessage, StudyShape, study_shape
from kitrobot.workspace.child_processes import cores, has_processes
from kitrobot.workspace.mission_loader import OpenMission

MOST_RUNS = 20_000
"""Runs of a study that a page begins; it shows larger ones too."""
MOST_RUNS_TOLD = 5000
"""Runs that a page is told of at a time."""
_TIMES_ITS_COST = 5
_LEAST_PAUSE_S = 1.0
"""Between two looks at the whole study while it grows."""


def study_request(asked: ExperimentAskShape) -> StudyRequest:
    """What a page asks for. Programs do not vary there: their values are files of this machine.

    Raises:
        ExperimentError: one does.
    """
    for axis in asked.axes:
        if axis.address.strip().startswith(PROGRAM):
            raise ExperimentError(
                Sentence("`{address}` has files as its values, which a page cannot name", axis.address.strip()),
                Sentence("vary whole programs with `kitrobot sweep`"),
            )
    axes = [(axis.address, axis.values) for axis in asked.axes]
    return StudyRequest(
        axes, seeds=asked.seeds, seconds=asked.seconds, fail_rate=asked.fail_rate, measures=asked.measures
    )


def plan_page_study(opened: OpenMission, asked: ExperimentAskShape) -> Plan:
    """The plan of a study that a page asks for.

    Raises:
        ProblemsError: the mission has errors.
        ExperimentError: something of the request makes no sense, or it is too much for a page.
    """
    plan = plan_study(opened, study_request(asked))
    if plan.rows > MOST_RUNS:
        raise ExperimentError(
            Sentence("this study has {count} runs; the studio begins at most {most}", plan.rows, MOST_RUNS),
            Sentence("choose fewer values or seeds, or use `kitrobot sweep`"),
        )
    return plan


def begin_page_study(folder: Path, opened: OpenMission, asked: ExperimentAskShape) -> Path:
    """The folder of a study that a page asks for, among those of the mission's folder; the very same one is found.

    Raises:
        as `plan_page_study`; ExperimentError too: the folder cannot be written.
    """
    plan = plan_page_study(opened, asked)
    place = choose_study_folder(folder, plan)
    begin_study(place, plan)
    return place


class StudyWork:
    """The making of a study's rows, with what a page is told meanwhile."""

    def __init__(self, folder: Path, send: Callable[[ExperimentProgressMessage], None]) -> None:
        self._study = StudyRows(folder)
        self._send = send
        self._began = time.monotonic()
        self._first = -1
        self._next_look = self._began + _LEAST_PAUSE_S

    def run(self, stop: Callable[[], bool]) -> StudyShape:
        """Makes what is missing, until `stop` says otherwise; the study then.

        Raises:
            ExperimentError: it is of another version, somebody else is at it, or the disk refuses.
        """
        jobs = max(2, cores() - 1) if has_processes() else 1
        run_study(self._study.folder, choose_executor(jobs, None), None, self._came_to, stop)
        return study_shape(self._study)

    def _came_to(self, done: int, total: int) -> None:
        now = time.monotonic()
        if self._first < 0:
            self._first = done
        made = done - self._first
        left = (total - done) * (now - self._began) / made if made else None
        study = None
        if now >= self._next_look and done < total:
            study = study_shape(self._study)
            ended = time.monotonic()
            self._next_look = ended + max(_LEAST_PAUSE_S, _TIMES_ITS_COST * (ended - now))
        self._send(ExperimentProgressMessage(done=done, total=total, left_s=left, study=study))


def study_runs(study: StudyRows, first: int, count: int) -> list[StudyRow]:
    """The rows that are there among `count` from number `first` on, by number."""
    last = first + min(count, MOST_RUNS_TOLD)
    return sorted((row for row in study if first <= row.number < last), key=lambda row: row.number)
