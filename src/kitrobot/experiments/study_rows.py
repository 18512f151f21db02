"""The rows of a study as they are read, and the run behind each of them.

Rows are read from the folder as they are asked for, so a study that is still being made can be looked at.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any

from kitrobot.experiments.addresses import ExperimentError
from kitrobot.experiments.meters import Number
from kitrobot.experiments.plan import Function, Plan
from kitrobot.experiments.point_runner import DIED, ERROR, PointRunner
from kitrobot.experiments.study_folder import open_study, study_rows
from kitrobot.experiments.variant import Value
from kitrobot.text.json_text import from_json
from kitrobot.text.sentences import Sentence
from kitrobot.workspace.traces import OpenTrace, open_trace

NO_RUN = (ERROR, DIED)
"""Outcomes of rows behind which there is no run."""


@dataclass(frozen=True)
class StudyRow:
    """One run of a study.

    Attributes:
        number: its number in the plan.
        id: 24 hexadecimal digits, the hash of what decides the run.
        seed: where its chance began.
        point: the values that were put into the mission, by address.
        outcome: done, failed, stuck or time; error for a mission that cannot be run with these values, died for one
            whose process died every time.
        sentence: why.
        seconds: simulated time; None without a run.
        measures: what was measured, by name; None for nothing, as of a condition that never held.
        wrong: why a measure in Python gave no number, by name.
    """

    number: int
    id: str
    seed: int
    point: Mapping[str, Value]
    outcome: str
    sentence: str
    seconds: float | None
    measures: Mapping[str, Number]
    wrong: Mapping[str, str]
    _study: StudyRows = field(repr=False, compare=False)

    def record(self, file: Path | None = None) -> Path:
        """Records this very run as a `.krtrace`: see `StudyRows.record`."""
        return self._study.record(self, file)

    def replay(self) -> OpenTrace:
        """Records this very run and opens the recording; whoever asks closes its `reader`."""
        return open_trace(self.record())


class StudyRows:
    """The plan of a study in its folder, and its rows so far.

    Args:
        folder: where it is.
        functions: its measures in Python, by name; `record` needs them.

    Raises:
        ExperimentError: there is none.
    """

    def __init__(self, folder: Path, functions: Mapping[str, Function] | None = None) -> None:
        self.folder = folder
        self.plan: Plan = open_study(folder)
        self._functions = functions or {}

    def __iter__(self) -> Iterator[StudyRow]:
        """The rows that are there, each once, in the order in which they ended."""
        for row in study_rows(self.folder, self.plan):
            yield study_row(row, self)

    def __len__(self) -> int:
        return sum(1 for _ in study_rows(self.folder, self.plan))

    def __repr__(self) -> str:
        return f"{type(self).__name__}({str(self.folder)!r}: {len(self)} of {self.plan.rows} runs)"

    @property
    def rows(self) -> list[StudyRow]:
        """The rows that are there, in the order of the plan: points, and the seeds of each."""
        return sorted(self, key=lambda row: row.number)

    def worst(self, measure: str) -> StudyRow:
        """The row with the largest number.

        Raises:
            ExperimentError: nothing of that name was measured.
        """
        return self._extreme(measure, lambda number: -number)

    def best(self, measure: str) -> StudyRow:
        """The row with the smallest number.

        Raises:
            ExperimentError: nothing of that name was measured.
        """
        return self._extreme(measure, lambda number: number)

    def row(self, word: int | str) -> StudyRow:
        """The row of that number, or whose id begins so.

        Raises:
            ExperimentError: it is not there.
        """
        text = str(word)
        for row in self:
            if row.number == word if isinstance(word, int) else row.id.startswith(text):
                return row
        raise ExperimentError(Sentence("the study has no row `{row}`", text))

    def record(self, row: StudyRow, file: Path | None = None) -> Path:
        """Records the very run of a row as a `.krtrace`, in the study's folder unless another file is named.

        Raises:
            ExperimentError: there is no run behind the row, or it comes out differently with this version.
            TraceError: the file cannot be written.
        """
        if row.outcome in NO_RUN:
            raise ExperimentError(Sentence("there is no run behind this row: {reason}", row.sentence))
        path = file if file is not None else self.folder / f"{row.id}.krtrace"
        again = study_row(from_json(self._runner.record(row.number, path)), self)
        if again != row:
            raise ExperimentError(
                Sentence("the run of row {row} comes out differently", row.number),
                Sentence("this study was begun with KitRobot {version}", self.plan.version),
            )
        return path

    @cached_property
    def _runner(self) -> PointRunner:
        return PointRunner(self.plan, self._functions)

    def _extreme(self, measure: str, key: Callable[[float], float]) -> StudyRow:
        found: tuple[float, int, StudyRow] | None = None
        for row in self:
            number = row.measures.get(measure)
            if number is not None and math.isfinite(number):
                one = (key(number), row.number, row)
                found = one if found is None or one[:2] < found[:2] else found
        if found is None:
            raise ExperimentError(Sentence("no row of the study has the measure `{name}`", measure))
        return found[2]


def study_row(row: Mapping[str, Any], study: StudyRows) -> StudyRow:
    """A row from what its line says."""
    return StudyRow(
        row["row"],
        row["id"],
        row["seed"],
        row["point"],
        row["outcome"],
        row["sentence"],
        row.get("seconds"),
        row.get("measures", {}),
        row.get("wrong", {}),
        study,
    )
