"""`kitrobot start` and `kitrobot stop`: the program on real robots."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Annotated

import typer

from kitrobot.cli.deploy import Addresses
from kitrobot.cli.speaking import complain, tell, tell_of_waiting

if TYPE_CHECKING:
    from kitrobot.deploy import Board

Everyone = Annotated[bool, typer.Option("--all", help="Every robot that is there.")]


def start_boards(to: Addresses = None, everyone: Everyone = False) -> None:
    """Start the program that is on a robot, from its beginning."""
    _each(to or [], everyone, lambda board: board.start(), "started")


def stop_boards(to: Addresses = None, everyone: Everyone = False) -> None:
    """Stop the program on a robot, and all its motors. It stays there, and starts again when the power comes on."""
    _each(to or [], everyone, lambda board: board.stop(), "stopped")


def _each(to: Sequence[str], everyone: bool, act: Callable[[Board], None], word: str) -> None:
    from kitrobot.deploy import list_ports
    from kitrobot.workspace import at_boards, chosen_boards

    if everyone and to:
        raise typer.BadParameter("choose one of --all and --to")
    named = [port.address for port in list_ports()] if everyone else list(to)
    good = True
    for address, error in at_boards(chosen_boards(named), act, tell_of_waiting):
        if error is None:
            tell(f"{address}: {word}")
        else:
            tell(f"{address}:")
            complain(error)
            good = False
    if not good:
        raise typer.Exit(1)
