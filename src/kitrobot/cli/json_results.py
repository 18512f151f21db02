"""What the commands for real robots give as JSON: what became of each robot."""

from __future__ import annotations

from typing import Annotated, Any

import typer

from kitrobot.cli.output import error_object
from kitrobot.diagnostics import KitRobotError

AsJson = Annotated[bool, typer.Option("--json", help="Give a list of JSON objects.")]


def of_board(address: str, error: KitRobotError | None, **more: Any) -> dict[str, Any]:
    """What became of one robot: `ok`, and the error or the rest."""
    if error is not None:
        return {"address": address, "ok": False, "error": error_object(error)}
    return {"address": address, "ok": True, **more}
