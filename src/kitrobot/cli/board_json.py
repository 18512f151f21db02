"""What the commands for real robots give as JSON when they fail: the same object wherever it stands."""

from __future__ import annotations

import json
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Annotated, Any

import typer

from kitrobot.cli.speaking import complain, give
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


@contextmanager
def failures_as_json(as_json: bool) -> Iterator[None]:
    """With `--json` an error is `{"error": …}` on standard output too, and the exit status is 1."""
    try:
        yield
    except KitRobotError as error:
        if not as_json:
            raise
        complain(error)
        give(json.dumps({"error": error_object(error)}, ensure_ascii=False) + "\n")
        raise typer.Exit(1) from None
