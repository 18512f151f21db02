"""`kitrobot watch`: what real robots do right now, and a recording of it."""

from __future__ import annotations

import json
import math
import sys
import time
from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from kitrobot.cli.output import (
    error_object,
    json_text,
    print_data,
    print_error,
    print_late_ticks,
    print_message,
    print_no_answer,
    sanitize,
)

if TYPE_CHECKING:
    from rich.console import Group

    from kitrobot.deploy.line.news import Fault, News, Text
    from kitrobot.robots.view import WatchedRobot

Boards = Annotated[
    list[str] | None,
    typer.Option(
        "--to",
        metavar="PORT|URL",
        help="A robot: a serial port or a URL such as `socket://HOST:PORT`. Several times for several robots.",
        show_default="the only one that is there",
    ),
]
Board = Annotated[
    str | None,
    typer.Option(
        "--to",
        metavar="PORT|URL",
        help="The robot: a serial port or a URL such as `socket://HOST:PORT`.",
        show_default="the only one that is there",
    ),
]
Mission = Annotated[
    Path | None,
    typer.Option(
        "--mission",
        metavar="FILE",
        help="The mission that was sent, when it was sent from another computer.",
        show_default=False,
    ),
]
Program = Annotated[
    str | None,
    typer.Option("--program", metavar="NAME", help="Which program of that mission.", show_default=False),
]


Robot = Annotated[
    str | None,
    typer.Option(
        "--robot",
        metavar="NAME|FILE.robot.xml",
        help="The robot of an `.lll`; a `.krt` names its own.",
        show_default=False,
    ),
]


def watch_board(
    to: Boards = None,
    mission: Mission = None,
    program: Program = None,
    robot: Robot = None,
    period: Annotated[int, typer.Option(min=20, max=60000, metavar="MS", help="At most one message in so long.")] = 100,
    seconds: Annotated[
        float | None, typer.Option(metavar="S", help="Ends by itself then.", show_default="until Ctrl-C")
    ] = None,
    trace: Annotated[
        Path | None,
        typer.Option(metavar="FILE.krtrace", help="Record it: all robots in one recording, which the studio plays."),
    ] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Give one JSON object a line and message.")] = False,
) -> None:
    """Show what robots do: where their programs are, their variables and their inputs, until Ctrl-C.

    A robot goes on when you stop watching, and is not slowed down by it, but for a moment when the watch begins. One
    whose link is lost is told, and the others are watched on.
    """
    if seconds is not None and not (math.isfinite(seconds) and seconds > 0):
        raise typer.BadParameter("watching takes more than 0 seconds", param_hint="'--seconds'")
    from kitrobot.boards.monitor import record_robots, watched_robot
    from kitrobot.robots.board_operations import choose_boards

    with ExitStack() as stack:
        watched = [
            stack.enter_context(watched_robot(address, mission, program, robot, partial(print_no_answer, address)))
            for address in choose_boards(to or [])
        ]
        for one in watched:
            if one.names is None:
                called = one.hello.program
                print_message(f"{one.address}: the program {called} was not sent from here; only its numbers are known")
                print_message("  help: name the mission with --mission")
        recorder = None
        if trace is not None:
            recorder = record_robots(trace, watched, mission)
            stack.callback(recorder.close)
        failed = _watch(watched, period, math.inf if seconds is None else seconds, as_json)
        if recorder is not None:
            recorder.close()
            if recorder.error is not None:
                print_error(recorder.error)
            print_message(f"recorded in {recorder.path}; `kitrobot {recorder.path}` plays it")
            failed |= recorder.error is not None
    if failed:
        raise typer.Exit(1)


def _watch(watched: Sequence[WatchedRobot], period: int, seconds: float, as_json: bool) -> bool:
    """Watches for `seconds`, until Ctrl-C, or until no robot answers any more; returns whether a link was lost."""
    there = list(watched)
    slow: list[WatchedRobot] = []
    try:
        for one in watched:
            one.begin(period)
        until = time.monotonic() + seconds
        with _display(watched, as_json) as on_change:
            while there and (left := until - time.monotonic()) > 0:
                for one in tuple(there):
                    error = one.listen(min(left, 0.5 / len(there)))
                    if error is not None:
                        there.remove(one)
                        print_error(error)
                        if as_json:
                            print_data(json.dumps({"board": one.address, "error": error_object(error)}) + "\n")
                        continue
                    on_change(one)
                    if one.is_slow and one not in slow:
                        slow.append(one)
                        print_late_ticks(one.address)
    except KeyboardInterrupt:
        pass
    finally:
        for one in there:
            one.end()
    return len(there) < len(watched)


@contextmanager
def _display(watched: Sequence[WatchedRobot], as_json: bool) -> Iterator[Any]:
    """Yields a function that displays a robot after news: a table that stays in its place, or lines."""
    several = len(watched) > 1
    if as_json:
        yield lambda one: print_data(_json(one, one.news)) if one.news is not None else None
        return
    if not sys.stdout.isatty():
        yield lambda one: print_data(_lines(one, one.news, several)) if one.news else None
        return
    from rich.console import Console, Group
    from rich.live import Live

    def tables() -> Group:
        return Group(*(_table(one, several) for one in watched))

    with Live(tables(), console=Console(), refresh_per_second=10, transient=False) as live:
        yield lambda one: live.update(tables())


def _json(one: WatchedRobot, news: News | Fault | Text) -> str:
    found = json_text({"board": one.address, **one.to_json(news)})
    sys.stdout.flush()
    return found + "\n"


def _lines(one: WatchedRobot, news: News | Fault | Text, several: bool) -> str:
    before = f"{one.address}: " if several else ""
    return "".join(f"{sanitize(before + line)}\n" for line in one.describe(news))


def _table(one: WatchedRobot, several: bool) -> Group:
    from rich import box
    from rich.console import Group
    from rich.table import Table
    from rich.text import Text

    title = f"{one.address}: {one.title()}" if several else one.title()
    table = Table(box=box.SIMPLE, title=Text(sanitize(title)), title_justify="left")
    table.add_column("runs")
    table.add_column("variables")
    table.add_column("inputs")
    rows = [one.thread_places(), one.variables(), one.inputs()]
    table.add_row(*(Text("\n".join(sanitize(line) for line in row)) for row in rows))
    last = [Text(sanitize(line)) for line in one.printed[-5:]]
    return Group(table, *last)
