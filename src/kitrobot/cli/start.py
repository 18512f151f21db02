"""`kitrobot start` and `kitrobot stop`: the program on real robots."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Annotated

import typer

from kitrobot.cli.deploy import Addresses
from kitrobot.cli.output import json_text, print_data, print_error, print_message, print_no_answer
from kitrobot.cli.result_json import AsJson, board_result

if TYPE_CHECKING:
    from kitrobot.deploy.line.board import Board

Everyone = Annotated[bool, typer.Option("--all", help="Every robot that is there.")]


def start_boards(to: Addresses = None, everyone: Everyone = False, as_json: AsJson = False) -> None:
    """Start the program that is on a robot, from its beginning."""
    _each(to or [], everyone, as_json, lambda board: board.start(), "started")


def stop_boards(to: Addresses = None, everyone: Everyone = False, as_json: AsJson = False) -> None:
    """Stop the program on a robot, and all its motors. It stays there, and starts again when the power comes on."""
    _each(to or [], everyone, as_json, lambda board: board.stop(), "stopped")


def _each(to: Sequence[str], everyone: bool, as_json: bool, act: Callable[[Board], None], word: str) -> None:
    from kitrobot.deploy.firmware.ports import list_ports
    from kitrobot.robots.board_operations import choose_boards, run_on_boards

    if everyone and to:
        raise typer.BadParameter("choose one of --all and --to")
    named = [port.address for port in list_ports()] if everyone else list(to)
    good = True
    done = run_on_boards(choose_boards(named), act, print_no_answer)
    if as_json:
        print_data(json_text([board_result(address, error) for address, error in done], 2) + "\n")
    for address, error in done:
        if error is None:
            print_message(f"{address}: {word}")
        else:
            print_message(f"{address}:")
            print_error(error)
            good = False
    if not good:
        raise typer.Exit(1)
