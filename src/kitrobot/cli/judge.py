"""`kitrobot judge`: properties, asked of several judges; text, or JSON."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from kitrobot.cli.judgements import print_judgements
from kitrobot.cli.options import IsApproximate, Jobs, ResultAsJson
from kitrobot.cli.output import print_diagnostics
from kitrobot.cli.run import FailRate, Seed, check_run_numbers

if TYPE_CHECKING:
    from kitrobot.judges.judgement import Judgement
    from kitrobot.workspace.mission_loader import OpenMission

JudgedFiles = Annotated[
    list[Path],
    typer.Argument(
        metavar="FILE.krt | RUN.krtrace…",
        help="A mission; or recordings, and perhaps the mission whose properties are meant.",
        show_default=False,
    ),
]
Properties = Annotated[
    list[str] | None,
    typer.Option(
        "--property",
        metavar="PROPERTY",
        help="A name, or a property as text such as `never any carrier (Collision.IsPressed())`; may be given again. "
        "Else all of the mission's own.",
        show_default=False,
    ),
]
JudgeNames = Annotated[
    list[str] | None,
    typer.Option(
        "--by",
        metavar="check|run|runs|failures",
        help="Who judges a mission; may be given again. Else all.",
        show_default=False,
    ),
]
TimingNames = Annotated[
    list[str] | None,
    typer.Option(
        "--timing",
        metavar="lockstep|prompt|free",
        help="When agents tick in the check; may be given again. Else lockstep.",
        show_default=False,
    ),
]
RunSeconds = Annotated[float, typer.Option(help="Simulated seconds after which a run is out of time.")]
CheckSeconds = Annotated[float, typer.Option(metavar="S", help="At most so long for the check of one property.")]
MostRuns = Annotated[int, typer.Option("--runs", metavar="N", min=1, help="So many runs are made by `runs`.")]
Moments = Annotated[int, typer.Option(metavar="N", min=1, help="Robots fail at so many moments.")]


def judge_files(
    files: JudgedFiles,
    properties: Properties = None,
    judges: JudgeNames = None,
    timings: TimingNames = None,
    seed: Seed = 1,
    seconds: RunSeconds = 600.0,
    fail_rate: FailRate = 0.0,
    check_seconds: CheckSeconds = 60.0,
    runs: MostRuns = 100,
    moments: Moments = 20,
    jobs: Jobs = None,
    approximate: IsApproximate = False,
    as_json: ResultAsJson = False,
) -> None:
    """Ask several judges whether properties hold: the check, a run, many runs, every failure; or recordings.

    The exit status is 0 when all is kept, 1 when a judge finds something broken, and 3 when nothing is broken and a
    judge could not decide.
    """
    from kitrobot.judges.mission_judges import MISSION_JUDGES, judge_mission, judge_options
    from kitrobot.workspace.mission_loader import open_mission
    from kitrobot.workspace.mission_run import RunOptions

    check_run_numbers(seed, seconds, fail_rate)
    recordings, mission = split_files(files)
    if recordings:
        if judges:
            raise typer.BadParameter("a recording is its own judge", param_hint="'--by'")
        print_judgements(judge_recordings(recordings, properties or (), mission), as_json)
        return
    assert mission is not None, "there is a file"
    chosen = judges or MISSION_JUDGES, timings or ("lockstep",), check_seconds, runs, moments, jobs
    options = judge_options(*chosen, approximate=approximate)
    prepared = open_mission(mission).prepare(RunOptions(seed, seconds, fail_rate))
    print_diagnostics(prepared.problems, prepared.sources)
    print_judgements(judge_mission(prepared, properties or (), options), as_json)


def split_files(files: Sequence[Path]) -> tuple[list[Path], Path | None]:
    """The recordings among files, and the mission beside them; with no recording there is one mission."""
    from kitrobot.workspace.traces import is_trace

    recordings = [one for one in files if is_trace(one.name)]
    missions = [one for one in files if not is_trace(one.name)]
    if len(missions) > 1:
        raise typer.BadParameter("one mission at a time is judged", param_hint="'FILE.krt'")
    return recordings, missions[0] if missions else None


def judge_recordings(
    recordings: Sequence[Path], properties: Sequence[str], mission: Path | None
) -> Iterator[Judgement]:
    """What recordings say, one after the other."""
    from kitrobot.judges.recording_judge import judge_recording
    from kitrobot.workspace.mission_loader import open_mission

    opened: OpenMission | None = open_mission(mission) if mission is not None else None
    for recording in recordings:
        yield from judge_recording(recording, properties, opened)
