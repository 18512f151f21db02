"""`kitrobot log`: why a real robot stopped, and what it printed."""

from __future__ import annotations

import math
import time
from typing import Annotated, Any

import typer

from kitrobot.cli.output import json_text, print_data, print_no_answer, sanitize
from kitrobot.cli.watch import Board, Mission, Program, Robot

_LISTEN_S = 0.5


def show_log(
    to: Board = None,
    mission: Mission = None,
    program: Program = None,
    robot: Robot = None,
    follow: Annotated[bool, typer.Option("--follow", "-f", help="Stay, and show what comes, until Ctrl-C.")] = False,
    as_json: Annotated[bool, typer.Option("--json", help="Give one JSON object a line.")] = False,
) -> None:
    """Show the last fault of a robot, with the place in the program, and the text that the robot prints."""
    from kitrobot.boards.monitor import known_program
    from kitrobot.deploy.errors import SilentError
    from kitrobot.deploy.line.handshake import connect
    from kitrobot.deploy.line.news import Fault, Text
    from kitrobot.robots.board_operations import choose_boards
    from kitrobot.robots.view import fault_object, fault_sentence

    def say(sentence: str, found: dict[str, Any]) -> None:
        print_data(json_text(found) + "\n" if as_json else f"{sanitize(sentence)}\n")

    address = choose_boards([to] if to is not None else [])[0]
    try:
        board = connect(address, waits=lambda: print_no_answer(address))
    except SilentError as error:
        printed = getattr(error, "printed", "").strip()
        if printed:
            say(printed, {"kind": "text", "text": printed})
        raise
    with board:
        known = known_program(board.hello, mission, program, robot)
        names = known.names if known is not None else None
        fault = board.last_fault()
        if fault is None:
            say("no fault", {"kind": "fault", "number": 0})
        else:
            say(fault_sentence(fault, names), fault_object(fault, names))
        until = math.inf if follow else time.monotonic() + _LISTEN_S
        try:
            while time.monotonic() < until:
                news = board.news(_LISTEN_S)
                if isinstance(news, Text):
                    text = news.text.strip("\n")
                    say(text, {"kind": "text", "text": text})
                elif isinstance(news, Fault):
                    say(fault_sentence(news, names), fault_object(news, names))
        except KeyboardInterrupt:
            pass
