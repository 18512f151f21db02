"""Studies in Python: `sweep` begins one or goes on with it, `Study` gives its rows, numbers, tables and runs."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from csv import writer
from io import StringIO
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from kitrobot.experiments.comparison import Comparison, compare
from kitrobot.experiments.executor import Executor, ThisProcess
from kitrobot.experiments.plan import Function, StudyRequest, plan_study
from kitrobot.experiments.seeds import seeds_of
from kitrobot.experiments.statistics.interval import USUAL_CONFIDENCE
from kitrobot.experiments.study_folder import begin_study
from kitrobot.experiments.study_html import study_html
from kitrobot.experiments.study_rows import StudyRows
from kitrobot.experiments.study_run import Progress, run_study
from kitrobot.experiments.summary import PointSummary, summarise
from kitrobot.experiments.tables import arrow_table, write_csv, write_parquet
from kitrobot.experiments.variant import Value
from kitrobot.workspace.child_processes import check_jobs, cores, has_processes
from kitrobot.workspace.mission_loader import OpenMission

Axes = Mapping[str, Sequence[Value] | str]
Measures = Sequence[str] | Mapping[str, str | Function]


class Study(StudyRows):
    """A study in its folder: an iterable of `StudyRow`, with summaries, comparisons and tables.

    Args:
        folder: where it is.
        functions: its measures in Python, by name; recording a run needs them.

    Raises:
        ExperimentError: there is none.
    """

    _kept: TemporaryDirectory[str] | None = None
    """The folder of a study that is nowhere else: it goes with the study."""

    def summary(self, ci: float = USUAL_CONFIDENCE) -> list[PointSummary]:
        """Every point with its outcomes and the interval of each measure, in the order of the plan.

        Args:
            ci: the share (0…1) of intervals that hold the truth.
        """
        return summarise(self, ci)

    def compare(
        self, address: str, measure: str = "", ci: float = USUAL_CONFIDENCE, *, paired: bool = True
    ) -> list[Comparison]:
        """Each value of an address against its first: the differences of runs with all else, and the seed, in common.

        Args:
            address: what varies.
            measure: of what; the first one that is measured unless it is named.
            ci: the share (0…1) of intervals that hold the truth.
            paired: False sets all runs of a value against all of the first one, whatever their seeds: Welch's t, and
                of `done` Newcombe's interval and Fisher's exact test.

        Raises:
            ExperimentError: nothing of that name varies, or was measured.
            StatisticsError: there are too few runs.
        """
        return compare(self, address, measure or self.plan.measured[0], ci, paired)

    def to_csv(self, file: Path | str) -> None:
        """Writes the rows as a CSV file."""
        with Path(file).open("w", encoding="utf-8", newline="") as out:
            write_csv(self, out)

    def to_parquet(self, file: Path | str) -> None:
        """Writes the rows as a Parquet file (`kitrobot[data]`)."""
        write_parquet(self, Path(file))

    def __arrow_c_stream__(self, requested_schema: Any = None) -> Any:
        """The rows for whatever reads Arrow: `pandas`, `polars`, DuckDB, pyarrow (`kitrobot[data]`)."""
        return arrow_table(self).__arrow_c_stream__(requested_schema)

    def plot(self, measure: str = "", ci: float = USUAL_CONFIDENCE) -> Any:
        """A `matplotlib.figure.Figure` (`kitrobot[plot]`): of one axis a curve with intervals, of two a map.

        Args:
            measure: of what; the first one that is measured unless it is named.
            ci: the share (0…1) of intervals that hold the truth.

        Raises:
            ExperimentError: more than two numbers vary, or nothing of that name was measured.
            KitRobotError: matplotlib is not installed.
        """
        from kitrobot.experiments.study_plot import plot_study

        return plot_study(self, measure or self.plan.measured[0], ci)

    def _repr_html_(self) -> str:
        """The study in a notebook: its numbers as a table."""
        return study_html(self)

    def to_pandas(self) -> Any:
        """The rows as a `pandas.DataFrame`; pandas must be there, arro3 need not."""
        import pandas

        text = StringIO()
        write_csv(self, text)
        text.seek(0)
        return pandas.read_csv(text)


def sweep_mission(
    opened: OpenMission,
    *,
    vary: Axes | None = None,
    seeds: Iterable[int] = (1,),
    measures: Measures = (),
    folder: Path | None = None,
    executor: Executor | None = None,
    progress: Progress | None = None,
    **chosen: Any,
) -> Study:
    """Runs a mission many times; see `kitrobot.sweep`. `chosen` are other fields of `StudyRequest`."""
    texts, functions = _measures(measures)
    axes = [(name, values if isinstance(values, str) else _axis(values)) for name, values in (vary or {}).items()]
    request = StudyRequest(axes, seeds=seeds_of(seeds).text, measures=texts, functions=functions or None, **chosen)
    kept = TemporaryDirectory() if folder is None else None
    place = Path(kept.name) / "study" if kept is not None else folder
    assert place is not None, "one of the two"
    begin_study(place, plan_study(opened, request))
    run_study(place, executor, progress=progress, functions=functions)
    study = Study(place, functions)
    study._kept = kept
    return study


def choose_executor(jobs: int | None, cluster: str | None) -> Executor:
    """What makes the rows: a Dask cluster where one is named, else so many processes (None: one a core), or this one.

    Raises:
        ExperimentError: Dask is needed and not installed.
        JobsError: there are too many processes, or none.
    """
    check_jobs(jobs)
    if cluster is not None:
        from kitrobot.experiments.cluster import DaskCluster

        return DaskCluster(cluster, jobs)
    count = jobs or cores()
    if count < 2 or not has_processes():
        return ThisProcess()
    from kitrobot.experiments.local_workers import LocalWorkers

    return LocalWorkers(count)


def _axis(values: Sequence[Value]) -> str:
    out = StringIO()
    writer(out, lineterminator="").writerow(values)
    return out.getvalue()


def _measures(given: Measures) -> tuple[list[str], dict[str, Function]]:
    if not isinstance(given, Mapping):
        return list(given), {}
    texts = [f"{name}={text}" for name, text in given.items() if isinstance(text, str)]
    functions: dict[str, Callable[[Any], Any]] = {
        name: function for name, function in given.items() if not isinstance(function, str)
    }
    return texts, functions
