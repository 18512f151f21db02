"""What the commands for real robots give as JSON: what became of each robot."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any

import typer

from kitrobot.cli.output import error_object
from kitrobot.diagnostics import KitRobotError

if TYPE_CHECKING:
    from kitrobot.deploy import DeployResult

AsJson = Annotated[bool, typer.Option("--json", help="Give a list of JSON objects.")]


def of_board(address: str, error: KitRobotError | None, **more: Any) -> dict[str, Any]:
    """What became of one robot: `ok`, and the error or the rest."""
    if error is not None:
        return {"address": address, "ok": False, "error": error_object(error)}
    return {"address": address, "ok": True, **more}


def of_deployed(done: DeployResult) -> dict[str, Any]:
    """What a board that was sent to has and tells now."""
    return {
        "program": done.program,
        "package": done.package,
        "micropython": done.micropython,
        "generation": done.generation,
        "free": done.free,
        "bytes": done.bytes_sent,
        "seconds": round(done.seconds, 3),
    }
