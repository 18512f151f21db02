"""`kitrobot watch`: what a real robot does right now."""

from __future__ import annotations

import json
import math
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from kitrobot.cli.speaking import clean, give, tell

if TYPE_CHECKING:
    from rich.console import Group

    from kitrobot.deploy import Fault, News, Text
    from kitrobot.workspace.board_watching import View

_PATIENCE_S = 0.5

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


def watch_board(
    to: Board = None,
    mission: Mission = None,
    program: Program = None,
    period: Annotated[int, typer.Option(min=20, max=60000, metavar="MS", help="At most one message in so long.")] = 100,
    seconds: Annotated[
        float | None, typer.Option(metavar="S", help="Ends by itself then.", show_default="until Ctrl-C")
    ] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Give one JSON object a line and message.")] = False,
) -> None:
    """Show what a robot does: where its program is, its variables and its inputs, until Ctrl-C.

    The robot goes on when you stop watching, and is not slowed down by it.
    """
    if seconds is not None and not (math.isfinite(seconds) and seconds > 0):
        raise typer.BadParameter("watching takes more than 0 seconds", param_hint="'--seconds'")
    from kitrobot.deploy import connect
    from kitrobot.workspace import chosen_boards
    from kitrobot.workspace.board_watching import View, names_for

    address = chosen_boards([to] if to is not None else [])[0]
    with connect(address) as board:
        names = names_for(board.hello, mission, program)
        if names is None:
            tell(f"{address}: the program {board.hello.program} was not sent from here; only its numbers are known")
            tell("  help: name the mission with --mission")
        view = View(board.hello, names)
        until = math.inf if seconds is None else time.monotonic() + seconds
        board.watch(period)
        try:
            with _shown(view, as_json) as show:
                while (left := until - time.monotonic()) > 0:
                    news = board.news(min(left, _PATIENCE_S))
                    if news is None:
                        view.renew(board.greet())
                    else:
                        view.take(news)
                    show(news)
        except KeyboardInterrupt:
            pass
        finally:
            board.watch(0)


@contextmanager
def _shown(view: View, as_json: bool) -> Iterator[Any]:
    """What shows the view after some news: a table that stays in its place, or lines."""
    if as_json:
        yield lambda news: give(_json(view, news)) if news is not None else None
        return
    if not sys.stdout.isatty():
        yield lambda news: give(_lines(view, news)) if news is not None else None
        return
    from rich.console import Console
    from rich.live import Live

    with Live(_table(view), console=Console(), refresh_per_second=10, transient=False) as live:
        yield lambda news: live.update(_table(view))


def _json(view: View, news: News | Fault | Text) -> str:
    found = json.dumps(view.to_json(news), ensure_ascii=False)
    sys.stdout.flush()
    return found + "\n"


def _lines(view: View, news: News | Fault | Text) -> str:
    return "".join(f"{clean(line)}\n" for line in view.told(news))


def _table(view: View) -> Group:
    from rich import box
    from rich.console import Group
    from rich.table import Table
    from rich.text import Text

    table = Table(box=box.SIMPLE, title=Text(clean(view.title())), title_justify="left")
    table.add_column("runs")
    table.add_column("variables")
    table.add_column("inputs")
    rows = [view.standing(), view.values(view.variables), view.values(view.inputs)]
    table.add_row(*(Text("\n".join(clean(line) for line in row)) for row in rows))
    last = [Text(clean(line)) for line in view.printed[-5:]]
    return Group(table, *last)
