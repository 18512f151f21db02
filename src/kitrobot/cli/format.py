"""`kitrobot format`: LLL in the one true layout."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated

import typer

from kitrobot.cli.output import print_data, print_diagnostics, print_error, print_message
from kitrobot.diagnostics.model import KitRobotError
from kitrobot.text.sentences import Sentence

STDIN = "-"


def format_files(
    files: Annotated[list[str], typer.Argument(metavar="FILE.lll…", help="LLL texts; `-` is standard input.")],
    write: Annotated[bool, typer.Option("--write", help="Put the result in the file's place.")] = False,
    check: Annotated[bool, typer.Option("--check", help="Exit with 1 if a file would change; write nothing.")] = False,
) -> None:
    """Lay out LLL texts the one true way; comments are kept.

    The result goes to standard output. Only the syntax is looked at, so no robot is needed. A text with a mistake is
    not touched: the mistake is shown and the exit status is 1.
    """
    if write and check:
        raise typer.BadParameter("choose one of --write and --check")
    if write and STDIN in files:
        raise typer.BadParameter("standard input cannot be written to; leave out --write")
    good = True
    for name in files:
        try:
            good &= _format(name, write, check)
        except KitRobotError as error:
            print_error(error)
            good = False
    if not good:
        raise typer.Exit(1)


def _format(name: str, write: bool, check: bool) -> bool:
    from kitrobot.files.layout import lay_out, lay_out_file

    if name == STDIN:
        if sys.stdin is None:
            raise KitRobotError(
                Sentence("standard input is closed, so there is nothing to lay out"), Sentence("name a file")
            )
        layout = lay_out(sys.stdin.buffer.read(), Path("<stdin>"))
    else:
        layout = lay_out_file(Path(name))
    if layout.text is None:
        print_diagnostics(layout.diagnostics, [layout.source])
        return False
    if check:
        if layout.changed:
            print_message(f"{layout.source.name}: would change")
        return not layout.changed
    if write:
        if layout.write():
            print_message(f"{layout.source.name}: written")
    else:
        print_data(layout.text)
    return True
