"""`kitrobot site DIR`: a folder with the whole studio in it, for any web server that hands out files."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from kitrobot.cli.output import clean, tell


def write_site(
    folder: Annotated[Path, typer.Argument(metavar="DIR", help="The folder to write; it must be new or empty.")],
    parts: Annotated[
        list[Path] | None,
        typer.Option(
            help="A folder with npm's package `pyodide`, or with pydantic_core's wheel for it. Can be given twice.",
        ),
    ] = None,
) -> None:
    """Write the studio as a static site, where Python runs in the page: for any web server, under any path."""
    from kitrobot.workspace.site import make_site

    made = make_site(folder, parts or [])
    mega = 1_000_000
    tell(f"{clean(str(folder))}: {made.files} files, {made.size / mega:.1f} MB")
