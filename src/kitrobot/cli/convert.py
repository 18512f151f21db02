"""`kitrobot convert`: a program from one form into another, a recording for other tools, by the names of the files."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from kitrobot.cli.output import print_diagnostics, print_message
from kitrobot.cli.progress import counted_progress


def convert_file(
    source: Annotated[Path, typer.Argument(metavar="A", help="The file to read.", show_default=False)],
    target: Annotated[Path, typer.Argument(metavar="B", help="The file to write.", show_default=False)],
    program: Annotated[
        str | None,
        typer.Option(metavar="NAME", help="Which program of a `.krt` with several; what to call one that is made."),
    ] = None,
    robot: Annotated[
        str | None,
        typer.Option(metavar="NAME|FILE.robot.xml", help="The robot of an LLL text or a tree, or of a team's program."),
    ] = None,
) -> None:
    """Turn a program or a recording into another form; the endings of the names say which.

    - `.krt` mission (graphs) → `.lll`, `.kri`, `.kra`, `.xml`
    - `.lll` LLL text → `.krt`, `.kri`, `.kra`, `.xml`
    - `.xml` behaviour tree of BehaviorTree.CPP 4 → `.krt`, `.lll`, `.kri`, `.kra`
    - `.svg`, `.png`, `.pdf`, `.hex`, `.uf2` file with a mission inside → `.krt`, `.lll`, `.kri`, `.kra`
    - `.kri` image → `.kra`
    - `.kra` three-address listing → `.kri`, byte for byte the image that was listed
    - `.krtrace` recording → `.mcap`, for Foxglove, PlotJuggler and ROS 2

    A text or a tree becomes a mission that runs at once: its program, and one agent `robot-1` that runs it in the empty
    world. Nothing is written when the program has errors.
    """
    from kitrobot.workspace.conversion import convert
    from kitrobot.workspace.recording_export import export_recording, is_export

    if is_export(source, target):
        with counted_progress("Writing ticks") as progress:
            is_whole = export_recording(source, target, progress)
        print_message(
            f"{target}: written" if is_whole else f"{target}: written as far as {source} goes, which is cut off"
        )
        return
    done = convert(source, target, program=program, robot=robot)
    print_diagnostics(done.diagnostics, done.sources)
    if not done.written:
        raise typer.Exit(1)
    print_message(f"{target}: written")
