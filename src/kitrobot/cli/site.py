"""`kitrobot site DIR`: a folder with the whole studio in it, for any web server that hands out files."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Annotated

import typer

from kitrobot.cli.output import print_message, sanitize

FirstMissions = Callable[[], dict[str, bytes]]
"""Gives the missions that a site draws before Python is there; the server knows how the page gets them."""


def write_site(
    context: typer.Context,
    folder: Annotated[Path, typer.Argument(metavar="DIR", help="The folder to write; it must be new or empty.")],
    parts: Annotated[
        list[Path] | None,
        typer.Option(
            help="A folder with Pyodide, or with pydantic_core's wheel for it, where `kitrobot_site_parts` is not "
            "installed. Can be given twice.",
        ),
    ] = None,
) -> None:
    """Write the studio as a static site, where Python runs in the page: for any web server, under any path."""
    from kitrobot.packaging.site import make_site

    first: FirstMissions | None = context.obj
    made = make_site(folder, parts or [], first=first() if first is not None else {})
    mega = 1_000_000
    print_message(f"{sanitize(str(folder))}: {made.files} files, {made.size / mega:.1f} MB")
