"""`kitrobot bench`: the parts of a robot by hand, one after the other."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from kitrobot.cli.deploy import STAGES
from kitrobot.cli.language import Language, translated
from kitrobot.cli.options import Replace
from kitrobot.cli.output import error_object, json_text, print_data, print_error, print_message, sanitize
from kitrobot.cli.watch import Board
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.text.sentences import Sentence

if TYPE_CHECKING:
    from kitrobot.boards.bench import Bench, BenchStep
    from kitrobot.boards.bench_run import BenchRun

_HELP = "keys: Enter begins the step and ends it, n the next one, b the one before, q leaves; leaving stops everything"

Port = Annotated[
    str,
    typer.Argument(
        metavar="[PORT|URL]",
        help="The robot: a serial port or a URL such as `socket://HOST:PORT`.",
        show_default="the only one that is there",
    ),
]
KitName = Annotated[
    str | None,
    typer.Option(
        "--board",
        metavar="NAME|FILE.board.xml",
        help="The kit that the robot is built of; without it as the robot's own file says.",
        show_default=False,
    ),
]


def try_parts(
    port: Port = "",
    to: Board = None,
    robot: Annotated[
        str | None,
        typer.Option(
            metavar="NAME|FILE.robot.xml",
            help="The robot; without it all parts that a kit may have.",
            show_default=False,
        ),
    ] = None,
    board: KitName = None,
    all_of_it: Annotated[
        bool, typer.Option("--all", help="Try every part for a moment, without keys, and give a table.")
    ] = False,
    seconds: Annotated[float, typer.Option(min=0.1, max=30.0, metavar="S", help="How long, with --all.")] = 1.0,
    replace: Replace = False,
    language: Language = "en",
    as_json: Annotated[bool, typer.Option("--json", help="As --all, as a list of JSON objects.")] = False,
) -> None:
    """Try each part of a robot by hand, with what is to be seen and what to look for when nothing happens.

    Lift the wheels off the ground first. A program that waits for you is put on the robot in the place of the one that
    it has. Everything stops when you leave, at Ctrl-C, and within a second when the cable is pulled. With --all or
    --json the exit status is 1 when a part failed.
    """
    from kitrobot.boards.bench import bench_of
    from kitrobot.boards.bench_run import BenchRun
    from kitrobot.boards.calibration import bench_robot
    from kitrobot.translation.reader_language import override_language
    from kitrobot.workspace.kit_files import find_kit
    from kitrobot.workspace.robots import find_robot

    if robot is None and board is None:
        raise typer.BadParameter("say --robot NAME, --board NAME, or both", param_hint="'--robot'")
    by_keys = not (all_of_it or as_json)
    if by_keys and not (sys.stdin is not None and sys.stdin.isatty() and sys.stdout is not None):
        raise typer.BadParameter("without a terminal say --all or --json", param_hint="'--all'")
    folder = Path.cwd()
    kit = find_kit(board, folder) if board is not None else None
    bench = bench_of(find_robot(robot, folder) if robot is not None else bench_robot(), kit, folder)
    address = robot_address(port, to)
    print_message("lift the wheels off the ground")
    with override_language(language):
        with BenchRun(address, bench, send_progress(), replace=replace) as run:
            if by_keys:
                _control_by_keys(run, bench)
                return
            rows = _try_steps(run, bench, seconds)
        if as_json:
            print_data(json_text(rows, 2) + "\n")
        else:
            _table(rows, bench)
    if not all(row["ok"] for row in rows):
        raise typer.Exit(1)


def robot_address(port: str, to: str | None) -> str:
    """The robot that is named before the options or with --to; without either the only one that is there."""
    from kitrobot.robots.board_operations import choose_boards

    if port and to:
        raise typer.BadParameter("the robot is named twice: say the port once", param_hint="'--to'")
    (address,) = choose_boards([named] if (named := to or port) else [])
    return address


def send_progress() -> Any:
    """Tells what is done, on standard error, once for each stage."""
    last = ""

    def progress(stage: str, done: int, total: int) -> None:
        nonlocal last
        if stage != last:
            last = stage
            print_message(STAGES.get(stage, stage))

    return progress


def _try_steps(run: BenchRun, bench: Bench, seconds: float) -> list[dict[str, Any]]:
    """Tries every step; once the board is gone, the rest is not tried.

    Raises:
        KitRobotError: nothing could be tried.
    """
    from kitrobot.boards.bench_loader import PartError
    from kitrobot.boards.bench_run import OF_THE_BOARD

    rows: list[dict[str, Any]] = []
    gone: KitRobotError | None = None
    for step in bench.steps:
        row, error = _try_step(run, step, seconds, gone)
        if isinstance(error, PartError) and error.part != step.key:
            # It failed at the end of its own step, and that is reported in this one.
            for earlier in rows:
                if (earlier["category"], earlier["part"]) == error.part:
                    earlier |= {"ok": False, "error": error_object(error)}
            row, error = _try_step(run, step, seconds, gone)
        if isinstance(error, OF_THE_BOARD) and gone is None:
            if not rows:
                raise error
            gone = KitRobotError(Sentence("not tried: {reason}", error.message), error.help)
        rows.append(row)
    return rows


def _try_step(
    run: BenchRun, step: BenchStep, seconds: float, gone: KitRobotError | None
) -> tuple[dict[str, Any], KitRobotError | None]:
    """Tries one step for `seconds` and returns its result; `gone`: why it cannot be tried any more."""
    from kitrobot.primitives.value_format import format_value
    from kitrobot.translation.reader_language import translate

    values: list[int] = []
    error = gone
    slow = False
    try:
        if error is None:
            run.begin(step)
            values = run.watch(seconds)
            slow = run.is_slow
            run.end()
    except KitRobotError as found:
        error = found
    row = {
        "part": step.part.name,
        "category": step.part.category.value,
        "call": step.call,
        "seen": translated(step.seen),
        "help": translated(step.trouble),
        "ok": error is None,
        "values": values,
        "words": [translate(format_value(step.part, value, run.bench.robot.wait_unit_ms)) for value in values],
        "late": run.late,
        "slow": slow,
        "error": error_object(error) if error is not None else None,
    }
    return row, error


def _table(rows: list[dict[str, Any]], bench: Bench) -> None:
    from kitrobot.translation.reader_language import translate

    words = [(_step_name(row["part"], row["call"]), row) for row in rows]
    width = max(len(name) for name, _ in words)
    for name, row in words:
        print_data(f"{name.ljust(width)}  {_result_text(row)}\n")
    for part, why in bench.left_out:
        print_data(f"{sanitize(part.name).ljust(width)}  not here: {sanitize(translate(why))}\n")


def _step_name(part: str, call: str) -> str:
    return sanitize(call or part)


def _result_text(row: dict[str, Any]) -> str:
    if row["error"] is not None:
        return f"FAILED: {sanitize(row['error']['message'])}"
    values, words = row["values"], [sanitize(told) for told in row["words"]]
    seen = sanitize(row["seen"])
    if row["slow"]:
        seen += " (this part takes longer than a tick: programs that use it run slower than they say)"
    if not values:
        return f"done; {seen}"
    least, most = (words[values.index(one)] for one in (min(values), max(values)))
    told = least if len(values) == 1 else f"{least} to {most}"
    return f"{told}; {seen}"


def _control_by_keys(run: BenchRun, bench: Bench) -> None:
    """Steps by keys until the person leaves."""
    from kitrobot.boards.bench_run import OF_THE_BOARD
    from kitrobot.cli.key_input import ESCAPE, read_keys
    from kitrobot.primitives.value_format import format_value
    from kitrobot.translation.reader_language import translate

    print_message(_HELP)
    for part, why in bench.left_out:
        print_message(f"not here: {part.name}: {translate(why)}")
    at, going = 0, False
    with read_keys() as key:
        _show(bench, at)
        while True:
            pressed = key()
            try:
                run.poll(0.1 if going else 0.05)
                if going and run.is_on:
                    value = run.value
                    words = (
                        ""
                        if value is None
                        else translate(format_value(bench.steps[at].part, value, bench.robot.wait_unit_ms))
                    )
                    slow = "  (takes longer than a tick)" if run.is_slow else ""
                    _line(f"  on   {sanitize(words)}{slow}")
                if pressed in ("q", ESCAPE):
                    run.end()
                    _line("")
                    return
                if pressed in ("n", "b"):
                    run.end()
                    going = False
                    at = (at + (1 if pressed == "n" else -1)) % len(bench.steps)
                    _show(bench, at)
                elif pressed in ("\n", "\r", " "):
                    if going:
                        run.end()
                        _line("  off\n")
                    else:
                        run.begin(bench.steps[at])
                    going = not going
            except OF_THE_BOARD:
                raise
            except KitRobotError as error:
                _line("")
                print_error(error)
                going = False


def _show(bench: Bench, at: int) -> None:
    step = bench.steps[at]
    name = _step_name(step.part.name, step.call)
    _line(f"{at + 1} of {len(bench.steps)}  {name}\n  {sanitize(translated(step.seen))}\n")
    if step.trouble:
        print_data(f"  if not: {sanitize(translated(step.trouble))}\n")


def _line(text: str) -> None:
    """In the place of the line that stands there."""
    print_data(f"\r\x1b[K{text}")
    sys.stdout.flush()
