"""Arguments and options that several commands have."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

MissionFile = Annotated[Path, typer.Argument(metavar="FILE.krt", help="The mission.", show_default=False)]
WATCH_HELP = (
    "Watch for a property that breaks, a name or text such as `never any carrier (Collision.IsPressed())`; "
    "may be given again. Without it: the mission's own."
)
RunSeconds = Annotated[float, typer.Option(help="Simulated seconds after which the run is out of time.")]
Jobs = Annotated[int | None, typer.Option(metavar="N", min=1, help="In so many processes; else one for each core.")]
ResultAsJson = Annotated[bool, typer.Option("--json", help="Give the result as one JSON object.")]
ProgramName = Annotated[
    str | None,
    typer.Option("--program", metavar="NAME", help="Which program of a `.krt` with several.", show_default=False),
]
RobotName = Annotated[
    str | None,
    typer.Option(metavar="NAME|FILE.robot.xml", help="The robot; a `.krt` names its own.", show_default=False),
]
Replace = Annotated[bool, typer.Option("--replace", help="Overwrite a `main.py` on the board that is not KitRobot's.")]
ListenPort = Annotated[
    int | None,
    typer.Option(min=0, max=65535, help="The port to listen on; 0 is any free one.", show_default="8765 or near"),
]
IsApproximate = Annotated[
    bool,
    typer.Option(
        "--approximate",
        help="Forget states, to look at many more: it may find what breaks a property, and never says that one holds.",
    ),
]
