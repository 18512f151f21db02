"""`kitrobot merge`: two people's edits of one mission or kit, as git's merge driver calls it."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from kitrobot.cli.output import print_diagnostics, print_message

CONFLICT = 1


def merge_missions_of_files(
    base: Annotated[Path, typer.Argument(metavar="BASE", help="What both began with.", show_default=False)],
    ours: Annotated[Path, typer.Argument(metavar="OURS", help="Our file.", show_default=False)],
    theirs: Annotated[Path, typer.Argument(metavar="THEIRS", help="Their file.", show_default=False)],
    output: Annotated[
        Path | None, typer.Option("--output", "-o", metavar="OUT", help="Where to write; OURS without it.")
    ] = None,
) -> None:
    """Merge two edits of one `.krt` mission, or of one `.board.xml` of a kit.

    Edits of different parts both stand. Where both changed the same thing differently ours is kept, each such conflict
    is a sentence on standard error, and the exit status is 1. The result always opens. When a file cannot be used
    nothing is written and the status is 2.
    """
    from kitrobot.workspace.file_merge import merge_files

    merged = merge_files(base, ours, theirs, output or ours)
    print_diagnostics(merged.left_out, merged.sources)
    for one in merged.conflicts:
        print_message(f"conflict: {one.sentence}")
    if merged.conflicts:
        raise typer.Exit(CONFLICT)
