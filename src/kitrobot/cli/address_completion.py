"""What a shell offers behind `--vary` and `--compare`: the addresses of the mission or the study that was named.

A shell shows no message in the middle of a line, so where there is no such file, or it has errors, nothing is offered.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

import typer

from kitrobot.diagnostics.model import KitRobotError


def complete_axis(context: typer.Context, incomplete: str) -> Iterator[tuple[str, str]]:
    """Axes `ADDRESS=VALUES` of the mission, with values to begin with; beside each, what stands there and what can."""
    with suppress(KitRobotError, OSError):
        from kitrobot.experiments.mission_addresses import mission_addresses
        from kitrobot.workspace.mission_loader import open_mission

        opened = open_mission(_named(context))
        known = mission_addresses(opened).values() if opened.report.ok else ()
        for one in known:
            if one.name.startswith(incomplete.partition("=")[0]):
                now = "–" if one.current is None else str(one.current)
                yield f"{one.name}={one.example}", f"{now}; {one.expected}"


def complete_compared(context: typer.Context, incomplete: str) -> Iterator[str]:
    """The addresses that vary in the study."""
    with suppress(KitRobotError, OSError):
        from kitrobot.experiments.study_folder import open_study

        yield from (name for name in open_study(_named(context)).addresses if name.startswith(incomplete))


def _named(context: typer.Context) -> Path:
    """The mission or study among the words of the command so far, its last one."""
    # The parser leaves them where they are when it stops at an option without its value, as it does here.
    words = context.params.get("words") or context.args or ("",)
    return Path(os.path.expanduser(words[-1]))
