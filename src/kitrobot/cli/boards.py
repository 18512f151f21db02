"""`kitrobot boards`: which robots are there, and what runs on them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Annotated, Any

import typer

from kitrobot.cli.deploy import Addresses
from kitrobot.cli.deploy_set import table
from kitrobot.cli.output import (
    error_object,
    json_text,
    print_data,
    print_late_ticks,
    print_message,
    print_no_answer,
    sanitize,
)
from kitrobot.cli.result_json import AsJson, board_result

if TYPE_CHECKING:
    from kitrobot.robots.board_operations import BoardContents


Identify = Annotated[
    str | None,
    typer.Option(
        "--identify", metavar="PORT|URL", help="Let this robot show itself for two seconds.", show_default=False
    ),
]
LabelName = Annotated[
    str | None,
    typer.Option(
        "--label",
        metavar="NAME",
        help="The name on the label of the robot at --to, for `kitrobot deploy --set`; an empty one takes it away.",
        show_default=False,
    ),
]


def list_boards(
    to: Addresses = None,
    identify: Identify = None,
    label: LabelName = None,
    as_json: AsJson = False,
) -> None:
    """List the robots that are there, and what runs on them.

    They are looked for on USB, and at the addresses that KITROBOT_BOARDS names, with spaces between them.
    """
    if identify is not None:
        from kitrobot.deploy.line.handshake import connect

        with connect(identify, waits=lambda: print_no_answer(identify)) as board:
            board.identify()
        if as_json:
            print_data(json_text([board_result(identify, None)], 2) + "\n")
        print_message(f"{identify}: look which robot shows itself")
        return
    if label is not None:
        _label(to or [], label, as_json)
        return
    from kitrobot.boards.labels import labels_of
    from kitrobot.boards.programs import scan_boards
    from kitrobot.deploy.line.board import is_slow

    seen = scan_boards(to or [], print_no_answer)
    labels = labels_of(one.port.address for one in seen)
    if as_json:
        print_data(json_text([{**_object(one), "label": labels.get(one.port.address, "")} for one in seen], 2) + "\n")
        return
    if not seen:
        print_message("no robot is plugged in")
        print_message("  help: plug one in with a USB cable that carries data, or name its address with --to")
        return
    _print_table(seen, labels)
    for one in seen:
        if one.hello is not None and is_slow(one.hello.state_name, one.hello.late, one.hello.tick):
            print_late_ticks(one.port.address)
        if one.error is not None:
            print_message(f"{one.port.address}: {one.error.message}")
            if one.port.firmware:
                print_message(f"  help: a board without MicroPython gets it from {one.port.firmware}")


def _print_table(seen: Sequence[BoardContents], labels: Mapping[str, str]) -> None:
    rows: list[tuple[str, ...]] = [
        ("port", "board", "state", "program", "KitRobot", "MicroPython", "generation", "memory left")
    ]
    rows += [_row(one) for one in seen]
    if labels:
        named = ["label", *(sanitize(labels.get(one.port.address, "")) for one in seen)]
        rows = [(name, *row) for name, row in zip(named, rows, strict=True)]
    for line in table(rows):
        print_data(line)


def _label(addresses: list[str], label: str, as_json: bool) -> None:
    if len(addresses) != 1:
        raise typer.BadParameter("say with --to which robot it is, once", param_hint="'--label'")
    from kitrobot.boards.labels import store_label

    kept = store_label(addresses[0], label)
    if as_json:
        print_data(json_text([board_result(addresses[0], None, label=kept)], 2) + "\n")
    print_message(f"{addresses[0]}: the label is {kept}" if kept else f"{addresses[0]}: no label")


def _row(seen: BoardContents) -> tuple[str, ...]:
    where = (sanitize(seen.port.address), sanitize(seen.port.name))
    hello = seen.hello
    if hello is None:
        return (*where, "no answer", "", "", "", "", "")
    program = f"{sanitize(seen.program)} ({hello.program})" if seen.program else sanitize(hello.program)
    had = (sanitize(hello.package), sanitize(seen.micropython) or "?", str(hello.generation), f"{hello.free} bytes")
    return (*where, hello.state_name, program, *had)


def _object(seen: BoardContents) -> dict[str, Any]:
    found: dict[str, Any] = {
        "address": seen.port.address,
        "name": seen.port.name,
        "description": seen.port.description,
        "answers": seen.hello is not None,
        "firmware": seen.port.firmware,
    }
    if seen.hello is not None:
        hello = seen.hello
        found |= {
            "state": hello.state_name,
            "fault": hello.fault,
            "tick": hello.tick,
            "late": hello.late,
            "free": hello.free,
            "generation": hello.generation,
            "package": hello.package,
            "program": hello.program,
            "micropython": seen.micropython,
            "name_of_program": seen.program,
        }
    elif seen.error is not None:
        found |= {"error": error_object(seen.error)}
    return found
