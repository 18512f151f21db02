"""`kitrobot [FILE.krt | FOLDER]`: the studio in the browser."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Protocol

import typer

from kitrobot.cli.options import ListenPort
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.text.sentences import Sentence


class StudioError(KitRobotError):
    """The studio cannot be opened on that."""


@dataclass(frozen=True)
class StudioOptions:
    """The options of `kitrobot studio`: `target` is a mission, a folder, or None for an example; `port` None: any;
    `new`: a second one, where one of the folder runs.
    """

    target: Path | None
    host: str
    port: int | None
    browser: bool
    new: bool = False


class Studio(Protocol):
    """Opens the studio and returns when it is closed."""

    def __call__(self, options: StudioOptions, /) -> None: ...


def open_studio(
    context: typer.Context,
    target: Annotated[
        str | None,
        typer.Argument(
            metavar="FILE.krt | FILE.krtrace | FOLDER",
            help="A mission, a file with one inside (`.svg`, `.png`, `.pdf`, `.hex`, `.uf2`), a recorded run, or"
            " a folder of missions.",
        ),
    ] = None,
    browser: Annotated[bool, typer.Option(help="Open the browser.")] = True,
    port: ListenPort = None,
    host: Annotated[str, typer.Option(help="The address of this machine to listen on.")] = "127.0.0.1",
    new: Annotated[bool, typer.Option("--new", help="Start a second studio where one of this folder runs.")] = False,
) -> None:
    """Open the studio in the browser; Ctrl-C ends it. Where one of the same folder runs, open a page of that."""
    path = _existing(target, _commands(context)) if target is not None else None
    studio: Studio | None = context.obj
    if studio is None:
        raise StudioError(
            Sentence("this command line was started without a studio"), Sentence("start it with `python -m kitrobot`")
        )
    studio(StudioOptions(path, host, port, browser, new))


def _commands(context: typer.Context) -> list[str]:
    """The names of all commands, in the order of the alphabet."""
    return sorted(getattr(context.find_root().command, "commands", ()))


def _existing(target: str, commands: list[str]) -> Path:
    from kitrobot.files.examples import find_mission

    path = find_mission(Path(target))
    if path.is_dir() or (path.is_file() and path.suffix.lower() == ".krt"):
        return path
    from kitrobot.files.embedded_mission import may_carry_mission, read_carried
    from kitrobot.workspace.traces import is_trace, open_trace

    if path.is_file() and is_trace(path.name):
        # As with pictures: one that cannot be played is reported before a browser opens.
        open_trace(path).reader.close()
        return path
    if path.is_file() and may_carry_mission(path.name):
        # A picture without a mission is reported here, before a browser opens.
        read_carried(path)
        return path
    if path.exists():
        ending = path.suffix
        raise StudioError(
            Sentence("The studio opens missions (`.krt`), and `{target}` is none", target),
            Sentence("turn it into one with `kitrobot convert`") if ending in (".lll",) else "",
        )
    if path.suffix or len(path.parts) > 1:
        from kitrobot.files.disk import suggest_similar_name

        raise StudioError(Sentence("there is no file or folder `{target}`", target), suggest_similar_name(path))
    from difflib import get_close_matches

    near = get_close_matches(target, commands, n=1)
    help = f"did you mean `kitrobot {near[0]}`?" if near else f"commands: {', '.join(commands)}"
    raise typer.BadParameter(f"`{target}` is no command, and there is no file or folder of that name; {help}")
