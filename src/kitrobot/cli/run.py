"""`kitrobot run`: a mission in the simulator, without a page."""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from kitrobot.cli.options import WATCH_HELP, MissionFile, ResultAsJson, RunSeconds
from kitrobot.cli.output import json_text, print_data, print_diagnostics, print_message
from kitrobot.cli.ros import STOPPED_BY_ROS, RosDomain, RosListen, RosRouter, ros_bridge, ros_network
from kitrobot.diagnostics.read_files import expect_outputs

if TYPE_CHECKING:
    from kitrobot.judges.judgement import Judgement
    from kitrobot.judges.run_watch import RunWatch
    from kitrobot.live.ros_bridge import RosBridge
    from kitrobot.primitives.kit import Kit
    from kitrobot.sim.event_text import Event
    from kitrobot.workspace.mission_run import PreparedRun, Run

AfterStep = Callable[[], "Sequence[Event]"]
"""Called after each step of a run; gives events to record."""

Seed = Annotated[int, typer.Option(min=0, help="Chance begins here: the same seed gives the same run.")]
TraceFile = Annotated[Path | None, typer.Option(metavar="FILE.krtrace", help="Record the run: same seed, same bytes.")]
Drawing = Annotated[Path | None, typer.Option(metavar="FILE.svg", help="Write what the pens drew as a picture.")]
Floor = Annotated[bool, typer.Option("--floor", help="Put the world's floor and walls under the drawing.")]
FailRate = Annotated[
    float,
    typer.Option(
        min=0.0,
        max=1.0,
        metavar="P",
        help="The probability that a robot fails for good within a minute, by chance: from the seed, 0 to 1.",
    ),
]
MeasuredKit = Annotated[
    str | None,
    typer.Option(
        "--board",
        metavar="NAME|FILE.board.xml",
        help="The robots drive and turn as this kit was measured (`kitrobot calibrate`).",
        show_default=False,
    ),
]
FailSweep = Annotated[
    int | None,
    typer.Option(
        min=0,
        metavar="[N]",
        help="Run it again for each robot and each of N moments (100; of pairs 20), at which that one fails.",
        show_default=False,
    ),
]
Pairs = Annotated[bool, typer.Option("--pairs", help="Sweep: two robots fail in each run.")]
Jobs = Annotated[
    int | None, typer.Option(metavar="N", min=1, help="Sweep: in so many processes; else one for each core.")
]
Watch = Annotated[
    list[str] | None,
    typer.Option(
        "--watch",
        metavar="[PROPERTY]",
        help=f"{WATCH_HELP} A sweep then says in which runs it breaks.",
        show_default=False,
    ),
]
HeatMap = Annotated[Path | None, typer.Option("--output", "-o", metavar="MAP.svg", help="Sweep: write a heat map.")]


def run_mission(
    file: MissionFile,
    seed: Seed = 1,
    seconds: RunSeconds = 600.0,
    trace: TraceFile = None,
    drawing: Drawing = None,
    floor: Floor = False,
    fail_rate: FailRate = 0.0,
    board: MeasuredKit = None,
    as_json: ResultAsJson = False,
    fail_sweep: FailSweep = None,
    pairs: Pairs = False,
    jobs: Jobs = None,
    picture: HeatMap = None,
    watched: Watch = None,
    ros: RosDomain = None,
    ros_listen: RosListen = None,
    ros_router: RosRouter = None,
) -> None:
    """Run a mission in the simulator, as fast as it goes; with `--ros` in real time.

    The exit status is 0 when the mission was done, and 1 when it failed, got stuck, ran out of time or has errors. Of a
    sweep it is 0 when it was done in every run, or with `--pairs` done or failed.
    Of a run that is watched it is also 1 when a property breaks.
    """
    from kitrobot.files.disk import replace_whole
    from kitrobot.trace.drawing_svg import drawing_svg
    from kitrobot.workspace.mission_loader import open_mission
    from kitrobot.workspace.mission_run import RunOptions
    from kitrobot.world.floor_svg import floor_svg

    check_run_numbers(seed, seconds, fail_rate)
    if fail_sweep is not None:
        _check_sweep(pairs, picture, watched, drawing, trace, ros)
    elif pairs or jobs is not None or picture is not None:
        raise typer.BadParameter("`--pairs`, `--jobs` and `--output` are of a sweep", param_hint="'--fail-sweep'")
    network = ros_network(ros, ros_listen, ros_router)
    if floor and drawing is None:
        raise typer.BadParameter("`--floor` is of a drawing", param_hint="'--drawing'")
    if board is not None and trace is not None:
        words = "a recording brings its robots along as their files say, not as a kit was measured"
        raise typer.BadParameter(words, param_hint="'--board'")
    kit = _measured_kit(board, file) if board is not None else None
    prepared = open_mission(file).prepare(RunOptions(seed, seconds, fail_rate, trace, kit))
    expect_outputs(trace, drawing, picture)
    print_diagnostics(prepared.problems, prepared.sources)
    if fail_sweep is not None and watched:
        _judge_failures(prepared, watched, fail_sweep, jobs, as_json)
        return
    if fail_sweep is not None:
        _sweep(prepared, fail_sweep, pairs, jobs, picture, as_json)
        return
    watch = _watch_of(prepared, watched) if watched else None
    with ros_bridge(prepared.simulation, network) as bridge, _progress(seconds) as progress:
        run = prepared.run(progress, _after_step(watch, bridge))
    if drawing is not None:
        world = prepared.simulation.world
        under = floor_svg(world) if floor else ()
        replace_whole(drawing, drawing_svg(run.strokes, world.width_mm, world.height_mm, under).encode())
    _print_run(run, watch.judgements(prepared.opened.name) if watch is not None else [], as_json)


def _after_step(watch: RunWatch | None, bridge: RosBridge | None) -> AfterStep | None:
    """What is done after each step of a run: it is watched, and sent to ROS 2. A stop from there is as Ctrl-C."""
    if bridge is None:
        return None if watch is None else watch.after_step

    def send() -> None:
        if not bridge.wait_until_due():
            raise KeyboardInterrupt(STOPPED_BY_ROS)
        bridge.publish()

    def send_after_step() -> Sequence[Event]:
        found = watch.after_step() if watch is not None else ()
        send()
        return found

    send()
    return send_after_step


def _print_run(run: Run, judgements: list[Judgement], as_json: bool) -> None:
    """Gives what came of a run and of what was watched in it, and ends with that status."""
    from kitrobot.cli.judgements import judgement_lines
    from kitrobot.judges.judgement import exit_status

    if as_json:
        more = {"watched": [one.to_json() for one in judgements]} if judgements else {}
        print_data(json_text(run.to_json() | more) + "\n")
    else:
        print_data(_summary(run) + "".join(f"{line}\n" for line in ("", *judgement_lines(judgements)) if judgements))
    if run.outcome != "done" or exit_status(judgements) == 1:
        raise typer.Exit(1)


def _check_sweep(
    pairs: bool,
    picture: Path | None,
    watched: list[str] | None,
    drawing: Path | None,
    trace: Path | None,
    ros: int | None,
) -> None:
    """Refuses what a sweep does not do."""
    if watched and (pairs or picture is not None):
        raise typer.BadParameter("properties are watched for where one robot fails", param_hint="'--watch'")
    if drawing is not None:
        raise typer.BadParameter("the many runs of a sweep are not drawn", param_hint="'--drawing'")
    if trace is not None:
        raise typer.BadParameter("the many runs of a sweep are not recorded", param_hint="'--trace'")
    if ros is not None:
        raise typer.BadParameter("the many runs of a sweep are not sent to ROS 2", param_hint="'--ros'")


def _sweep(
    prepared: PreparedRun, wanted: int, pairs: bool, jobs: int | None, picture: Path | None, as_json: bool
) -> None:
    """Runs a fail sweep, and ends with its status; `wanted` moments, 0 for as many as usual."""
    from kitrobot.cli.sweep import MOMENTS, MOMENTS_OF_PAIRS, sweep_mission
    from kitrobot.workspace.sweep import SweepOptions

    moments = wanted or (MOMENTS_OF_PAIRS if pairs else MOMENTS)
    sweep_mission(prepared, SweepOptions(moments, pairs, jobs), picture, as_json)


def watched_properties(prepared: PreparedRun, watched: Sequence[str]) -> list[str]:
    """The questions of `--watch`, with the mission's own properties in the place of one without a value."""
    own = [one.name for one in prepared.opened.mission.properties]
    if "" in watched and not own:
        words = "the mission has no properties of its own; name one"
        raise typer.BadParameter(words, param_hint="'--watch'")
    return [name for question in watched for name in ([question] if question else own)]


def _watch_of(prepared: PreparedRun, questions: list[str]) -> RunWatch:
    from kitrobot.judges.run_watch import RunWatch

    return RunWatch(prepared.simulation, watched_properties(prepared, questions))


def _judge_failures(prepared: PreparedRun, questions: list[str], moments: int, jobs: int | None, as_json: bool) -> None:
    """Says in which runs of a sweep properties break, and ends with that status."""
    from kitrobot.cli.judgements import print_judgements
    from kitrobot.judges.judgement import Judge
    from kitrobot.judges.many_runs import USUAL_MOMENTS, FailureOptions
    from kitrobot.judges.mission_judges import JudgeOptions, judge_mission

    chosen = JudgeOptions((Judge.FAILURES,), failures=FailureOptions(moments or USUAL_MOMENTS, jobs))
    print_judgements(judge_mission(prepared, watched_properties(prepared, questions), chosen), as_json)


def check_run_numbers(seed: int, seconds: float, fail_rate: float) -> None:
    """Refuses numbers that a run cannot have."""
    from kitrobot.sim.setup.limits import MAX_SECONDS, MAX_SEED

    if not math.isfinite(fail_rate):
        raise typer.BadParameter("a probability is a number from 0 to 1", param_hint="'--fail-rate'")
    if not 0 < seconds <= MAX_SECONDS:
        words = f"a run takes more than 0 and at most {MAX_SECONDS:.0f} seconds"
        raise typer.BadParameter(words, param_hint="'--seconds'")
    if seed > MAX_SEED:
        raise typer.BadParameter(f"a seed is a whole number from 0 to {MAX_SEED}", param_hint="'--seed'")


def _measured_kit(board: str, mission: Path) -> Kit:
    """The kit of that name or file; it says so where nothing was measured."""
    from kitrobot.workspace.kit_files import find_kit

    kit = find_kit(board, mission.parent)
    if not kit.measured:
        print_message(f"nothing was measured of the kit {kit.name}: the robots move as their own files say")
        print_message(f"  help: kitrobot calibrate --board {kit.name}")
    return kit


@contextmanager
def _progress(seconds: float) -> Iterator[Callable[[float], None] | None]:
    """A bar on standard error while a person watches; what it gives takes the simulated seconds so far."""
    if not sys.stderr.isatty():
        yield None
        return
    from rich.console import Console
    from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn

    columns = (TextColumn("{task.completed:.0f} s simulated"), BarColumn(), TimeElapsedColumn())
    with Progress(*columns, console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task("", total=seconds)
        yield lambda done: bar.update(task, completed=done)


def _summary(run: Run) -> str:
    """The result as people read it."""
    width = max((len(name) for name in run.delivered), default=0)
    counts = [f"  {name:<{width}}  {count:>5}" for name, count in run.delivered.items()]
    lines = [run.sentence, *(f"  help: {item.help}" for item in run.advice[:1] if item.help), ""]
    if counts:
        lines += [f"  {'delivered by':<{width}}", *counts, ""]
    real = run.timing.real_seconds
    lines += [
        f"  outcome     {run.outcome}",
        *([f"  delivered   {sum(run.delivered.values())} of {run.total}"] if run.total else []),
        f"  collisions  {run.collisions}",
        f"  simulated   {run.seconds:.2f} s in {run.ticks} tick{'' if run.ticks == 1 else 's'}",
        f"  real time   {real:.2f} s" + (f", {run.seconds / real:.0f} times as fast" if real > 0 else ""),
    ]
    return "\n".join(lines) + "\n"
