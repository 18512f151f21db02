"""What commands give as JSON in common: what became of a robot, and why a command failed."""

from __future__ import annotations

from typing import Annotated, Any

import typer

from kitrobot.diagnostics import KitRobotError, to_json

AsJson = Annotated[bool, typer.Option("--json", help="Give a list of JSON objects.")]


def error_object(error: KitRobotError) -> dict[str, Any]:
    """`message`, `help`, and `diagnostics` as `kitrobot check --json` gives them."""
    return {
        "message": error.message,
        "help": error.help,
        "diagnostics": [to_json(item) for item in error.diagnostics],
    }


def of_board(address: str, error: KitRobotError | None, **more: Any) -> dict[str, Any]:
    """What became of one robot: `ok`, and the error or the rest."""
    if error is not None:
        return {"address": address, "ok": False, "error": error_object(error)}
    return {"address": address, "ok": True, **more}
