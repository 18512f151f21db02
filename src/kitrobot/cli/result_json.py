"""The JSON of commands for real robots: the result for each robot."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any

import typer

from kitrobot.cli.output import error_object
from kitrobot.diagnostics.model import KitRobotError

if TYPE_CHECKING:
    from kitrobot.deploy.installation.deployment import DeployResult

AsJson = Annotated[bool, typer.Option("--json", help="Give a list of JSON objects.")]


def board_result(address: str, error: KitRobotError | None, **more: Any) -> dict[str, Any]:
    """The result for one robot: `ok`, and the error or the rest."""
    if error is not None:
        return {"address": address, "ok": False, "error": error_object(error)}
    return {"address": address, "ok": True, **more}


def deployed_result(done: DeployResult) -> dict[str, Any]:
    """The state of a board after a program was sent to it."""
    return {
        "program": done.program,
        "package": done.package,
        "micropython": done.micropython,
        "generation": done.generation,
        "free": done.free,
        "bytes": done.bytes_sent,
        "seconds": round(done.seconds, 3),
    }
