"""`kitrobot sweep`: studies of many runs; begun, gone on with, looked at, put together, given as tables."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from kitrobot.cli.address_completion import complete_axis, complete_compared
from kitrobot.cli.options import Jobs, RunSeconds
from kitrobot.cli.output import json_text, print_data
from kitrobot.cli.progress import counted_progress
from kitrobot.cli.run import FailRate

if TYPE_CHECKING:
    from kitrobot.experiments.executor import Executor
    from kitrobot.experiments.plan import StudyRequest
    from kitrobot.experiments.study import Study
    from kitrobot.experiments.study_run import StudyStatus

MERGE, TABLE = "merge", "table"

Words = Annotated[
    list[str],
    typer.Argument(
        metavar="FILE.krt | STUDY | merge STUDY… | table STUDY",
        help="A mission to begin a study of, or the folder of a study; with `--addresses`, how those begin.",
        show_default=False,
    ),
]
Vary = Annotated[
    list[str] | None,
    typer.Option(
        "--vary",
        metavar="ADDRESS=VALUES",
        help="What varies: a list `0,5,10`, a range `30:60:5` or `2..6`, or `lhs(20)`, `sobol(64)`, `random(100)`.",
        show_default=False,
        autocompletion=complete_axis,
    ),
]
Points = Annotated[
    Path | None,
    typer.Option("--points", metavar="FILE.csv", help="A line of addresses, then a line of values for each point."),
]
Seeds = Annotated[str, typer.Option("--seeds", metavar="SEEDS", help="The seeds of each point, as 1-1000 or 1,2,5.")]
Measures = Annotated[
    list[str] | None,
    typer.Option(
        "--measure",
        metavar="[NAME=]MEASURE",
        help="What is measured, as `seconds,distance` or `waited=time all carrier (…)`.",
        show_default=False,
    ),
]
Zip = Annotated[bool, typer.Option("--zip", help="Take the axes side by side instead of every combination.")]
Output = Annotated[
    Path | None, typer.Option("--output", "-o", help="The folder of the study, or the file of a table or recording.")
]
Resume = Annotated[bool, typer.Option("--resume", help="Go on with a study.")]
Status = Annotated[bool, typer.Option("--status", help="Say how far a study is.")]
ShardText = Annotated[
    str | None, typer.Option("--shard", metavar="I/N", help="Make only every N-th row, from the I-th on.")
]
Cluster = Annotated[
    str | None, typer.Option("--cluster", metavar="ADDRESS|local", help="Run on a Dask cluster (`kitrobot[cluster]`).")
]
Addresses = Annotated[
    bool, typer.Option("--addresses", help="List all that can vary in a mission, with what stands there and what can.")
]
Csv = Annotated[bool, typer.Option("--csv", help="table: as CSV.")]
Parquet = Annotated[bool, typer.Option("--parquet", help="table: as Parquet (`kitrobot[data]`).")]
Summary = Annotated[bool, typer.Option("--summary", help="table: a line for each point, with intervals.")]
Compare = Annotated[
    str | None,
    typer.Option(
        "--compare",
        metavar="ADDRESS",
        help="table: each value of an address against its first one, of the first `--measure`.",
        show_default=False,
        autocompletion=complete_compared,
    ),
]
Unpaired = Annotated[
    bool, typer.Option("--unpaired", help="With `--compare`: all runs against all, whatever their seeds.")
]
TraceOf = Annotated[str | None, typer.Option("--trace", metavar="ROW", help="Record the run of a row (number or id).")]
AsJson = Annotated[bool, typer.Option("--json", help="Plain values instead of text.")]


def sweep_missions(
    words: Words,
    vary: Vary = None,
    points: Points = None,
    seeds: Seeds = "1",
    measure: Measures = None,
    seconds: RunSeconds = 600.0,
    fail_rate: FailRate = 0.0,
    zip_axes: Zip = False,
    output: Output = None,
    resume: Resume = False,
    status: Status = False,
    shard: ShardText = None,
    jobs: Jobs = None,
    cluster: Cluster = None,
    addresses: Addresses = False,
    as_csv: Csv = False,
    as_parquet: Parquet = False,
    summary: Summary = False,
    compared: Compare = None,
    unpaired: Unpaired = False,
    trace: TraceOf = None,
    as_json: AsJson = False,
) -> None:
    """Run a mission many times while numbers of it vary, as a study that any crash leaves whole.

    `kitrobot sweep FILE --vary … -o STUDY` begins one, `kitrobot sweep STUDY --resume` goes on with it. The exit status
    is 0 when all runs are made, whatever came of them.
    """
    from kitrobot.experiments.plan import StudyRequest
    from kitrobot.experiments.study import Study, choose_executor
    from kitrobot.experiments.study_folder import is_study

    if words[0] == MERGE and len(words) > 1:
        _merge([Path(word) for word in words[1:]], output)
        return
    if words[0] == TABLE and len(words) == 2:
        if compared is not None:
            _compare(Study(Path(words[1])), compared, measure or [], not unpaired, as_json)
        else:
            _table(Study(Path(words[1])), output, as_parquet, summary, as_json)
        return
    path = Path(words[0])
    if addresses:
        _list_addresses(path, words[1:], as_json)
        return
    _expect_one(words, compared is not None or unpaired)
    request = StudyRequest(
        _axes(vary or []), points, zip_axes, seeds, seconds, fail_rate, [one for one in measure or [] if one.strip()]
    )
    is_there = resume or status or trace is not None or is_study(path)
    if is_there and (vary or points is not None or measure):
        raise typer.BadParameter("a study has its plan; another one is another folder", param_hint="'--vary'")
    folder = path if is_there else _begin(path, output, request)
    if trace is not None:
        _record(Study(folder), trace, output)
        return
    if not status:
        _run(folder, shard, choose_executor(jobs, cluster))
    _show_status(folder, as_json)


def _record(study: Study, row: str, output: Path | None) -> None:
    print_data(f"{study.record(study.row(int(row) if row.isdecimal() else row), output)}\n")


def _expect_one(words: list[str], compares: bool) -> None:
    """Refuses several words that name neither studies to merge nor one to tabulate, and a comparison of no table."""
    if len(words) > 1:
        raise typer.BadParameter("name one mission or one study", param_hint="'FILE'")
    if compares:
        raise typer.BadParameter("compare the runs of a study: kitrobot sweep table STUDY", param_hint="'--compare'")


def _axes(texts: list[str]) -> list[tuple[str, str]]:
    from kitrobot.experiments.axes import read_axis

    return [read_axis(text) for text in texts]


def _begin(file: Path, output: Path | None, request: StudyRequest) -> Path:
    from kitrobot.experiments.plan import plan_study
    from kitrobot.experiments.study_folder import begin_study
    from kitrobot.workspace.mission_loader import open_mission

    plan = plan_study(open_mission(file), request)
    folder = output if output is not None else Path(f"{plan.name}-study")
    begin_study(folder, plan)
    return folder


def _run(folder: Path, shard: str | None, executor: Executor) -> None:
    from kitrobot.experiments.study_run import read_shard, run_study

    with counted_progress("runs") as progress:
        try:
            run_study(folder, executor, read_shard(shard) if shard is not None else None, progress)
        except KeyboardInterrupt:
            raise KeyboardInterrupt(
                f"broken off; every run that ended is kept: kitrobot sweep {folder} --resume"
            ) from None


def _merge(folders: list[Path], output: Path | None) -> None:
    from kitrobot.experiments.study_run import merge_studies

    into = output if output is not None else folders[0]
    merge_studies(folders, into)
    _show_status(into, False)


def _show_status(folder: Path, as_json: bool) -> None:
    from kitrobot.experiments.study_run import study_status

    found = study_status(folder)
    if as_json:
        print_data(json_text({"done": found.done, "total": found.total, "outcomes": found.outcomes}) + "\n")
        return
    print_data(_status_text(folder, found))


def _status_text(folder: Path, found: StudyStatus) -> str:
    lines = [f"{folder}: {found.done} of {found.total} runs"]
    width = max((len(name) for name in found.outcomes), default=0)
    lines += [f"  {name:<{width}}  {count:>{len(str(found.total))}}" for name, count in sorted(found.outcomes.items())]
    return "\n".join(lines) + "\n"


def _table(study: Study, output: Path | None, as_parquet: bool, summary: bool, as_json: bool) -> None:
    from kitrobot.experiments.tables import write_csv, write_parquet

    if as_parquet:
        file = output if output is not None else study.folder / "rows.parquet"
        write_parquet(study, file)
        print_data(f"{file}\n")
    elif summary:
        from kitrobot.experiments.summary import summary_json, summary_text

        print_data(json_text(summary_json(study)) + "\n" if as_json else summary_text(study))
    elif output is not None:
        with output.open("w", encoding="utf-8", newline="") as file_out:
            write_csv(study, file_out)
    else:
        write_csv(study, sys.stdout)


def _compare(study: Study, address: str, measures: list[str], paired: bool, as_json: bool) -> None:
    from kitrobot.experiments.comparison import comparison_json, comparison_text

    names = measures or [study.plan.measured[0]]
    found = [study.compare(address, name, paired=paired) for name in names]
    if as_json:
        print_data(json_text([line for one in found for line in comparison_json(one)]) + "\n")
        return
    print_data("\n".join(comparison_text(address, one) for one in found))


def _list_addresses(path: Path, beginnings: list[str], as_json: bool) -> None:
    from kitrobot.diagnostics.problems import ProblemsError
    from kitrobot.experiments.addresses import find_address
    from kitrobot.experiments.mission_addresses import mission_addresses
    from kitrobot.experiments.tables import text_lines
    from kitrobot.text.sentences import Sentence
    from kitrobot.workspace.mission_loader import open_mission

    opened = open_mission(path)
    if not opened.report.ok:
        message = Sentence("`{mission}` has errors, so it was not run", opened.name)
        raise ProblemsError(message, "", opened.report.problems, opened.report.sources)
    known = mission_addresses(opened)
    shown = [one for one in known.values() if not beginnings or one.name.startswith(tuple(beginnings))]
    if not shown:
        find_address(known, beginnings[0])
    if as_json:
        listed = [{"address": one.name, "now": one.current, "expected": str(one.expected)} for one in shown]
        print_data(json_text(listed) + "\n")
        return
    rows = [(one.name, "–" if one.current is None else str(one.current), str(one.expected)) for one in shown]
    print_data("\n".join(text_lines(rows)) + "\n")
